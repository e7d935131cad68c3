// An element as convex pieces: its corners, cut by diagonals from the reflex ones.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/model.hpp"

namespace keyblock {

/// Corners counter-clockwise; edge i runs from corner i to corner i+1. An inner edge is a diagonal: the element goes on
/// behind it. An affine map keeps straight edges straight and pieces convex, so they hold for the whole run.
struct ConvexPiece {
  std::vector<VertexIndex> corners;
  std::vector<bool> is_inner;  ///< of edge i
};

using ConvexPieces = std::vector<ConvexPiece>;

/// One piece for a convex element; none for an element with inner edges only, or whose hole no cut joins to its outer
/// loop. Vertices on a straight edge are no corners, unless one side of it is inner.
ConvexPieces convex_pieces(const Model& model, ElementIndex element);

}  // namespace keyblock
