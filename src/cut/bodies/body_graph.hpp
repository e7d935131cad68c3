// Outlines of bodies and slits in them as one graph: what cuts a mathematical mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/point.hpp"
#include "problem/blocks.hpp"

namespace keyblock {

/// A straight piece between two nodes. Outlines say which body lies on either side; a slit (a joint that ends inside,
/// or that joins two loops) has the same body on both sides, whichever that is.
struct BodyPiece {
  int from = 0;
  int to = 0;
  bool is_slit = false;
  int left = -1;  ///< body to the left of from → to; -1: none, or a slit
  int right = -1;
  int joint_material = 0;  ///< index from 0
};

/// Pieces of outlines meet in nodes only; slits may cross everything.
struct BodyGraph {
  std::vector<Point> nodes;
  std::vector<BodyPiece> pieces;
  std::vector<int> materials;  ///< block material of each body, index from 0
};

/// A block of a block file as the only body.
BodyGraph graph_of(const BlockPolygon& block);

}  // namespace keyblock
