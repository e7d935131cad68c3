// Divides an element into convex pieces by diagonals from its reflex corners. Theory:
// docs/theory/04-contact-geometry.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/model.hpp"

namespace keyblock {

/// Sine of the turn between a diagonal and an edge below which another diagonal is preferred.
inline constexpr double kClearSine = 0.02;

/// Convex piece with corners counter-clockwise; edge i runs from corner i to corner i+1. An inner edge is a diagonal,
/// with more of the element behind it. An affine map keeps straight edges straight and pieces convex, so that pieces
/// are valid for the whole run.
struct ConvexPiece {
  std::vector<VertexIndex> corners;
  std::vector<bool> is_inner;   ///< of edge i
  std::vector<bool> is_reflex;  ///< of corner i, in the outline of the element
};

using ConvexPieces = std::vector<ConvexPiece>;

/// Returns the pieces of an element, one if it is convex. The result is empty for an element with inner edges only, and
/// for a hole that no cut joins to the outer loop. Vertices on a straight edge are not corners, unless one side is
/// inner.
ConvexPieces convex_pieces(const Model& model, ElementIndex element);

}  // namespace keyblock
