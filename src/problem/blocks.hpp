// What a block file says, and what cutting makes of a drawing: polygons with joint edges, and points that sit in
// blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/error.hpp"
#include "geometry/point.hpp"
#include "problem/rare.hpp"

namespace keyblock {

/// A corner of a block. `joint_material` belongs to the edge that arrives here (from the previous vertex),
/// index from 0.
struct BlockVertex {
  Point position;
  int joint_material = 0;

  bool operator==(const BlockVertex&) const = default;
};

/// A closed chain of vertices, the first not repeated; the block lies to the left of every edge.
using BlockLoop = std::vector<BlockVertex>;

/// Where the vertices of a loop lie.
inline std::vector<Point> points_of(const BlockLoop& loop) {
  std::vector<Point> points;
  points.reserve(loop.size());
  for (const BlockVertex& vertex : loop) points.push_back(vertex.position);
  return points;
}

/// One block: an outer loop (counter-clockwise) and any holes in it (clockwise).
struct BlockPolygon {
  int material = 0;  ///< block material, index from 0
  BlockLoop outer;
  std::vector<BlockLoop> holes;
  Place place = {};  ///< where a file says so

  /// The same block, wherever it is written.
  bool operator==(const BlockPolygon& other) const {
    return material == other.material && outer == other.outer && holes == other.holes;
  }
};

/// What becomes of blocks so small or so narrow that they are slivers.
enum class Slivers {
  kept,
  glued,     ///< each to the neighbour that it shares the longest length of side with
  left_out,  ///< they are not there
};

/// A point carried by a block.
struct BlockPoint {
  Point position;
  int block = 0;  ///< index from 0
  Place place;
};

/// A bolt between two blocks; ends, then the blocks that carry them (index from 0).
struct BlockBolt {
  Segment segment;
  int first_block = 0;
  int second_block = 0;
  double stiffness = 0;         ///< force / length
  double strength = 0;          ///< force
  double pretension = 0;        ///< force
  Place place = {};             ///< where a file says so
  Rare<std::string> name = {};  ///< of a case file; never empty
};

/// The blocks of a scene and their points. Lengths in the file's unit.
struct Blocks {
  std::vector<BlockPolygon> blocks;
  std::vector<BlockBolt> bolts;
  std::vector<BlockPoint> fixed_points;
  std::vector<BlockPoint> loading_points;
  std::vector<BlockPoint> measured_points;
  Place place;  ///< the file they come from
};

}  // namespace keyblock
