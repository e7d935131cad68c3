// Physical covers: the parts of the stars of mathematical nodes that hang together.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/manifold.hpp"

namespace keyblock {

/// Gives the elements, which know their neighbours, the covers that they make.
void set_covers(Manifold& manifold);

/// Lists the covers anew after elements were given those of others; covers that no element has are left out.
void relist_covers(Manifold& manifold);

}  // namespace keyblock
