// Computes the exact arrangement of outlines, slits and a triangular mesh without moving any point.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "cut/bodies/body_graph.hpp"
#include "cut/lines/arrangement.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// Side of triangles of the mesh; a triangle of -1 means that the mesh ends there.
struct MeshSide {
  std::array<int, 2> nodes{};  ///< nodes of the mesh
  int left = -1;               ///< triangle to the left of nodes[0] → nodes[1]
  int right = -1;
};

/// Source of an edge of the overlay. An edge belongs to a piece and a side if the piece runs along the side.
struct EdgeOrigin {
  int piece = -1;  ///< of the graph, in its direction if `piece_is_reversed` is false; -1: none
  int side = -1;   ///< of the mesh; -1: none
  bool piece_is_reversed = false;
  bool side_is_reversed = false;
};

struct Overlay {
  Arrangement arrangement;  ///< its lines: the pieces, then the sides
  std::vector<MeshSide> sides;
  std::vector<EdgeOrigin> origins;  ///< per edge
  double round_off = 0;             ///< distance below which rounding may separate equal points
};

/// Overlays the graph on the mesh. Exact predicates on the end points decide which pieces and sides meet, and their
/// order along each. Only crossings get new, rounded positions. Nodes of the graph that are nodes of the mesh up to
/// rounding get those positions.
Overlay overlay(const BodyGraph& graph, const TriangleMesh& mesh);

}  // namespace keyblock
