// Holds the contents of a geometry (line) file: lines that cut blocks, and marks on the drawing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "geometry/point.hpp"
#include "problem/rare.hpp"

namespace keyblock {

/// Line that may become edges of blocks.
struct JointLine {
  Segment segment;
  int joint_material = 0;  ///< index from 0 into the joint materials of the analysis
  Place place;
};

/// Line that gives its block material to every block it crosses; later lines win.
struct MaterialLine {
  Segment segment;
  int block_material = 0;  ///< index from 0
  Place place;
};

/// Axial spring between two points of two blocks (values per unit thickness).
struct BoltLine {
  Segment segment;
  double stiffness = 0;   ///< force / length
  double strength = 0;    ///< force
  double pretension = 0;  ///< force
  int type = 0;           ///< DDAML: index from 0 of the bolt properties
  Place place;
  Rare<std::string> name = {};  ///< from a case file; never empty
};

/// Fixed line: yields fixed points where it crosses block edges. Equal ends mean a point.
struct FixedLine {
  Segment segment;
  Place place;
};

/// Loading, measured or hole point of the drawing.
struct MarkedPoint {
  Point position;
  Place place;
};

/// Rule by which crossings nearer than the merging distance become one node.
enum class NodeMerging {
  nearest_first,  ///< nearest pairs first; the drawing, not the order of its lines, decides the place of the node
  /// Rule of Shi's programs: a crossing joins the first near node found before it, which stays in place.
  in_order_found,
};

/// Treatment of a piece of a joint that passes a node nearer than the drawing's distance, or crosses another after
/// nodes have moved.
enum class NearPieces {
  led_through,  ///< it goes through the node
  deleted,      ///< as in Shi's programs: it is lost, and its blocks may be open
};

/// Drawing of a geometry file. Lengths in the file's unit, indices from 0.
struct Drawing {
  double edge_node_ratio = 0;      ///< e0: snapping distance over the domain scale (Shi, line file token 1)
  std::vector<JointLine> joints;   ///< boundary lines first
  std::size_t boundary_count = 0;  ///< number of boundary lines in `joints`
  std::vector<MaterialLine> material_lines;
  std::vector<BoltLine> bolts;
  std::vector<FixedLine> fixed_lines;
  std::vector<MarkedPoint> loading_points;
  std::vector<MarkedPoint> measured_points;
  std::vector<MarkedPoint> hole_points;
  Place place;  ///< source file
};

}  // namespace keyblock
