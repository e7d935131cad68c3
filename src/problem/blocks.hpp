// Holds the blocks of a block file or of a cut drawing: polygons with joint edges, and points in blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/error.hpp"
#include "geometry/point.hpp"
#include "problem/rare.hpp"

namespace keyblock {

/// Corner of a block. `joint_material` belongs to the edge that arrives here from the previous vertex, index from 0.
struct BlockVertex {
  Point position;
  int joint_material = 0;

  bool operator==(const BlockVertex&) const = default;
};

/// Closed chain of vertices, the first not repeated; the block lies to the left of every edge.
using BlockLoop = std::vector<BlockVertex>;

/// Returns the positions of the vertices of a loop.
inline std::vector<Point> points_of(const BlockLoop& loop) {
  std::vector<Point> points;
  points.reserve(loop.size());
  for (const BlockVertex& vertex : loop) points.push_back(vertex.position);
  return points;
}

/// Block: an outer loop (counter-clockwise) and any holes in it (clockwise).
struct BlockPolygon {
  int material = 0;  ///< block material, index from 0
  BlockLoop outer;
  std::vector<BlockLoop> holes;
  Place place = {};  ///< set if it comes from a file

  /// Returns true for the same block, ignoring its place in a file.
  bool operator==(const BlockPolygon& other) const {
    return material == other.material && outer == other.outer && holes == other.holes;
  }
};

/// Treatment of slivers: blocks that are too small or too narrow.
enum class Slivers {
  kept,
  glued,     ///< each to the neighbour that shares the longest length of side
  left_out,  ///< deleted
};

/// Point carried by a block.
struct BlockPoint {
  Point position;
  int block = 0;  ///< index from 0
  Place place;
};

/// Bolt between two blocks: its ends, then the blocks that carry them (index from 0).
struct BlockBolt {
  Segment segment;
  int first_block = 0;
  int second_block = 0;
  double stiffness = 0;         ///< force / length
  double strength = 0;          ///< force
  double pretension = 0;        ///< force
  Place place = {};             ///< set if it comes from a file
  Rare<std::string> name = {};  ///< from a case file; never empty
};

/// Blocks of a scene and their points. Lengths in the file's unit.
struct Blocks {
  std::vector<BlockPolygon> blocks;
  std::vector<BlockBolt> bolts;
  std::vector<BlockPoint> fixed_points;
  std::vector<BlockPoint> loading_points;
  std::vector<BlockPoint> measured_points;
  Place place;  ///< source file
};

}  // namespace keyblock
