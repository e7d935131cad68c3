// Gives small pieces the covers of their neighbours, as Shi's manifold cutter does.
// Theory: docs/theory/13-shis-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/manifold.hpp"

namespace keyblock {

/// Absorbs each piece that is alone on one of its covers and whose area is below 0.2 of the mean. The piece takes the
/// triangle and the covers of its neighbour, so its own triangle no longer holds it, and there is one cover less. The
/// limit is a fit to Shi's samples: 65 pieces in twelve files, the largest absorbed 0.199, the smallest kept 0.209.
/// Returns the number of pieces absorbed.
int absorb_small_pieces(Manifold& manifold);

}  // namespace keyblock
