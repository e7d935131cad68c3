// Generates a drawing from an outline, tunnels and joint sets.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>
#include <vector>

#include "problem/drawing.hpp"
#include "problem/joints/joint_sets.hpp"
#include "problem/outline.hpp"

namespace keyblock {

/// Source of a drawing; indices from 0.
struct JointScene {
  std::variant<RectangleShape, SlopeShape, Outline> outline;
  std::vector<TunnelSection> tunnels;
  std::vector<JointSet> sets;
  int boundary_material = 0;  ///< joint material of outline and tunnels
  double edge_node_ratio = 0;
  std::vector<FixedLine> fixed_lines;
  std::vector<MarkedPoint> measured_points;
  Place place;
};

/// Returns the parts of a segment inside the outer loop and outside every other loop, in order.
std::vector<Segment> clipped(const Segment& segment, const std::vector<Outline>& loops);

/// Returns boundary lines around outline and tunnels, the traces of every set between them, and a hole point in every
/// tunnel. Throws InputError if a tunnel leaves the outline or meets another.
Drawing drawing_of(const JointScene& scene);

}  // namespace keyblock
