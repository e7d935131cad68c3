// Writes a cut mesh in the form of a cover file, with the points of the drawing in their elements.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/blocks.hpp"
#include "problem/cover.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// Returns the element of a body that holds the point, or the nearest if rounding leaves it in none. Returns -1 if the
/// body has no elements.
int element_at(const Manifold& manifold, int body, Point p);

/// Returns the points of the bodies, each in its element.
ElementPoints points_in_elements(const Manifold& manifold, const Blocks& blocks);

/// Returns the cover of a manifold. `blocks` must be its bodies; their points are kept, their bolts are not. An element
/// with holes becomes one chain, which runs to each hole and back on the same line.
Cover to_cover(const Manifold& manifold, const Blocks& blocks);

}  // namespace keyblock
