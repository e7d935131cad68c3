// Lays outlines and slits over a triangular mesh: the exact arrangement of both, nothing moved.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "cut/bodies/body_graph.hpp"
#include "cut/lines/arrangement.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// A side of triangles of the mesh; -1 where the mesh ends.
struct MeshSide {
  std::array<int, 2> nodes{};  ///< of the mesh
  int left = -1;               ///< triangle to the left of nodes[0] → nodes[1]
  int right = -1;
};

/// What an edge of the overlay is a part of. Where a piece runs along a side of the mesh, an edge is part of both.
struct EdgeOrigin {
  int piece = -1;  ///< of the graph, in its direction if `piece_is_reversed` is false; -1: none
  int side = -1;   ///< of the mesh; -1: none
  bool piece_is_reversed = false;
  bool side_is_reversed = false;
};

struct Overlay {
  Arrangement arrangement;  ///< its lines: the pieces, then the sides
  std::vector<MeshSide> sides;
  std::vector<EdgeOrigin> origins;  ///< of each edge
  double round_off = 0;             ///< what rounding may have made of no distance at all
};

/// Which pieces and sides meet, and in which order along each of them, is decided exactly from their end points. Only
/// crossings get new positions, rounded, and nodes of the graph
/// that are nodes of the mesh up to rounding.
Overlay overlay(const BodyGraph& graph, const TriangleMesh& mesh);

}  // namespace keyblock
