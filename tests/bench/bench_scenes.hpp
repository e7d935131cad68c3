// Builds walls, slopes and scattered blocks of any number for the measurements of time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "tests/support/standard_scenes.hpp"

namespace keyblock::bench {

/// A fixed floor and `side` courses of as many bricks of 1 m × 0.5 m in running bond. Every second course has half
/// bricks at its ends. `slope` rotates the whole scene [rad].
inline Blocks brick_wall(int side, double slope = 0) {
  Blocks blocks;
  const double width = side;
  blocks.blocks.push_back(support::turned_rectangle({-1, -2}, {width + 1, 0}, -slope));
  blocks.fixed_points = {{turned(Point{0, -1}, -slope), 0, {}}, {turned(Point{width, -1}, -slope), 0, {}}};
  for (int course = 0; course < side; ++course) {
    const double shift = course % 2 == 0 ? 0 : 0.5;
    for (double left = -shift; left < width; left += 1) {
      const Point low{std::max(0.0, left), 0.5 * course};
      blocks.blocks.push_back(support::turned_rectangle(low, {std::min(width, left + 1), low.y + 0.5}, -slope));
    }
  }
  return blocks;
}

/// Squares of half a metre that fall side by side without contact.
inline Blocks scatter(int side) {
  Blocks blocks;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const Point low{1.0 * column, 1.0 * row};
      blocks.blocks.push_back(support::rectangle(low, {low.x + 0.5, low.y + 0.5}));
    }
  return blocks;
}

/// A pyramid of squares of a metre, `rows` at its foot, on a fixed floor.
inline Blocks pyramid(int rows) {
  Blocks blocks;
  const double width = rows;
  blocks.blocks.push_back(support::rectangle({-2, -2}, {width + 2, 0}));
  blocks.fixed_points = {{{-1, -1}, 0, {}}, {{width + 1, -1}, 0, {}}};
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < rows - row; ++i) {
      const Point low{i + 0.5 * row, 1.0 * row};
      blocks.blocks.push_back(support::rectangle(low, {low.x + 1, low.y + 1}));
    }
  return blocks;
}

/// The scaling runs of the Berkeley program: 1 ms, E 5 GPa, penalty E, friction of 35 degrees, contacts within 50 mm.
inline Analysis scaling_analysis(const Blocks& blocks) {
  Analysis analysis = support::plain_analysis(1e-3, 1000000);
  analysis.joint_materials[0].friction_angle_deg = 35;
  Point low = blocks.blocks[0].outer[0].position;
  Point high = low;
  for (const BlockPolygon& block : blocks.blocks)
    for (const BlockVertex& corner : block.outer) {
      low = {std::min(low.x, corner.position.x), std::min(low.y, corner.position.y)};
      high = {std::max(high.x, corner.position.x), std::max(high.y, corner.position.y)};
    }
  const double half = std::max(high.x - low.x, high.y - low.y) / 2;
  analysis.allowed_displacement_ratio = 0.05 / (2.5 * half);
  return analysis;
}

/// R = p Δt² / 2m of a whole brick in the step of `scaling_analysis`.
inline constexpr double kRatioOfBricks = 2;

/// Steps of another R = p Δt² / 2m, if one is given.
inline Scene scene_for(const Blocks& blocks, const std::string& profile, double ratio = kRatioOfBricks) {
  Analysis analysis = scaling_analysis(blocks);
  analysis.time_step *= std::sqrt(ratio / kRatioOfBricks);
  const Settings settings = profile_settings(profile, analysis);
  if (settings.dynamics == Dynamics::standard) return support::standard_scene_of(blocks, analysis, settings);
  return {model_from_blocks(blocks, analysis), settings};
}

}  // namespace keyblock::bench
