// Where two elements may touch: of each pair of convex pieces, at most two corners of one against an edge of the other.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <vector>

#include "contact/candidates.hpp"
#include "contact/convex_pieces.hpp"

namespace keyblock {

/// A corner against an edge of another element, whose outside lies to the right of start → end. It is also the name by
/// which forces are remembered from step to step.
struct Touch {
  VertexIndex vertex;
  VertexIndex start;
  VertexIndex end;

  auto operator<=>(const Touch&) const = default;
};

using Touches = std::vector<Touch>;

/// The touches of the given pairs nearer than `reach`. For two convex pieces the line of reference is the edge, of either,
/// from which the other keeps the largest separation; the points are the ends of the stretch along which the most opposed
/// edge of the other faces it. Geometry alone decides (Ericson 2005, separating axes and clipping, from memory;
/// contact-notes 6). Inner edges may keep pieces apart, but nothing touches them.
Touches find_touches(const std::vector<ElementPair>& pairs, const Table<ElementIndex, ConvexPieces>& pieces,
                     const Table<VertexIndex, Point>& vertices, double reach);

}  // namespace keyblock
