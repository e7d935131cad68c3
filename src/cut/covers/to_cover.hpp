// A cut mesh as a cover file says it, with the points of the drawing in their elements.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/blocks.hpp"
#include "problem/cover.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// The element of a body that holds the point; where rounding leaves it in none, the nearest. -1: the body has none.
int element_at(const Manifold& manifold, int body, Point p);

/// The points of the bodies, each in its element.
ElementPoints points_in_elements(const Manifold& manifold, const Blocks& blocks);

/// `blocks` are the bodies of the manifold: their points go along, their bolts do not. An element with holes becomes
/// one chain, which runs to each hole and back on the same line.
Cover to_cover(const Manifold& manifold, const Blocks& blocks);

}  // namespace keyblock
