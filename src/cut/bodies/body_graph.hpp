// Holds the outlines of bodies and their slits as one graph, which cuts a mathematical mesh.
// Theory: docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/point.hpp"
#include "problem/blocks.hpp"

namespace keyblock {

/// Straight piece between two nodes. Outlines name the body on either side. A slit is a joint that ends inside a body
/// or joins two loops; it has the same body on both sides and names none.
struct BodyPiece {
  int from = 0;
  int to = 0;
  bool is_slit = false;
  int left = -1;  ///< body to the left of from → to; -1: no body, or a slit
  int right = -1;
  int joint_material = 0;  ///< index from 0
};

/// Outlines and slits of all bodies. Pieces of outlines meet in nodes only; slits may cross everything.
struct BodyGraph {
  std::vector<Point> nodes;
  std::vector<BodyPiece> pieces;
  std::vector<int> materials;  ///< block material of each body, index from 0
};

/// Returns the graph whose only body is the given block.
BodyGraph graph_of(const BlockPolygon& block);

}  // namespace keyblock
