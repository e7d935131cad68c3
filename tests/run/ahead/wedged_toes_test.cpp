// Toes that a floor holds are named; those that may pass are not.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/ahead/wedged_toes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/standard_scenes.hpp"

namespace keyblock::wedged_toes_test {
namespace {

BlockPolygon polygon(const std::vector<Point>& corners) {
  BlockPolygon block;
  for (const Point& corner : corners) block.outer.push_back({corner, 0});
  return block;
}

/// A bench on a plane from (8, 2 + above) that rises by `rise` over 10 m; the floor lies in front of x = 8 at y = 2.
Blocks bench(double rise, double above = 0) {
  const Point toe{8, 2 + above}, end{18, 2 + above + rise};
  std::vector<Point> base{{0, 0}, {18, 0}, end, toe, {8, 2}, {0, 2}};
  if (above == 0) base.erase(base.begin() + 4);
  Blocks blocks;
  blocks.blocks = {polygon(base), polygon({toe, end, {18, 12}, {11, 12}})};
  blocks.fixed_points = {{{1, 1}, 0, {}}, {{17, 1}, 0, {}}};
  return blocks;
}

std::string told(const Blocks& blocks, double friction_deg = 30) {
  Analysis analysis = support::plain_analysis(0.01, 50);
  analysis.joint_materials[0].friction_angle_deg = friction_deg;
  const Warnings found =
      wedged_toes(support::standard_scene_of(blocks, analysis, support::standard_settings(analysis)), {});
  return found.empty() ? "" : found[0].sentence;
}

Blocks mirrored(Blocks blocks) {
  for (BlockPolygon& block : blocks.blocks) {
    for (BlockVertex& vertex : block.outer) vertex.position.x = -vertex.position.x;
    std::ranges::reverse(block.outer);
  }
  for (auto& point : blocks.fixed_points) point.position.x = -point.position.x;
  return blocks;
}

}  // namespace

TEST(WedgedToes, a_plane_that_comes_out_at_the_floor_is_told) {
  EXPECT_NE(told(bench(5)).find("a sharp toe rests on the floor in front of it, the first of block 2 near 8, 2"),
            std::string::npos)
      << told(bench(5));
  EXPECT_NE(told(bench(5)).find("dips to it by 26.6 degrees"), std::string::npos);
  EXPECT_NE(told(mirrored(bench(5))).find("near -8, 2"), std::string::npos);
}

TEST(WedgedToes, what_passes_the_floor_or_would_not_slide_is_not) {
  EXPECT_EQ(told(bench(5, 0.3)), "") << "above the floor";
  EXPECT_EQ(told(bench(5), 46), "") << "friction alone holds it twice";
  EXPECT_EQ(told(bench(0)), "") << "a level plane";
  Blocks held = bench(5);
  held.fixed_points.push_back({{14, 8}, 1, {}});
  held.fixed_points.push_back({{15, 9}, 1, {}});
  EXPECT_EQ(told(held), "") << "fixed";
  Blocks buried = bench(5);
  buried.blocks.push_back(polygon({{0, 2}, {8, 2}, {9.5, 7}, {0, 7}}));
  EXPECT_EQ(told(buried), "") << "a buttress stands on the floor";
}

}  // namespace keyblock::wedged_toes_test
