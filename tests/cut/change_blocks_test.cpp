// Points and bolts stay with their block when others are excavated, also those outside it.
#include "cut/bodies/change_blocks.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace keyblock {
namespace {

BlockPolygon rectangle(Point low, Point high) {
  BlockPolygon block;
  for (const Point p : {low, Point{high.x, low.y}, high, Point{low.x, high.y}}) block.outer.push_back({p, 0});
  return block;
}

/// Two blocks side by side, 0 to 2 and 2 to 4, both 1 high.
Blocks two() {
  Blocks blocks;
  blocks.blocks = {rectangle({0, 0}, {2, 1}), rectangle({2, 0}, {4, 1})};
  return blocks;
}

ChangedBlocks without(const Blocks& blocks, Point low, Point high) {
  const Region region{{low, {high.x, low.y}, high, {low.x, high.y}}, 0};
  return without_regions(blocks, std::array{region});
}

TEST(ChangeBlocks, a_point_on_an_edge_stays_fixed_whatever_is_excavated) {
  Blocks blocks = two();
  const double outside = std::nextafter(2.0, 3.0);
  blocks.fixed_points = {{{outside, 0.25}, 0, {}}, {{0.5, 1 + 1e-13}, 0, {}}, {{3.5, -1e-14}, 1, {}}};
  const ChangedBlocks far = without(blocks, {3.2, 0.4}, {3.8, 0.6});  // within block 2, away from its point
  EXPECT_EQ(far.fixed_points, (std::vector{0, 1, 2}));
  const ChangedBlocks half = without(blocks, {-1, 0.5}, {5, 2});  // cuts both
  EXPECT_EQ(half.fixed_points, (std::vector{0, 2}));
  ASSERT_EQ(half.blocks.fixed_points.size(), 2U);
  EXPECT_EQ(half.blocks.fixed_points[0].block, 0);
  EXPECT_EQ(half.blocks.fixed_points[0].position.x, outside);
}

// Points of fixed lines are inset from the edge that the line crosses, and so lie outside a sharp corner.
TEST(ChangeBlocks, a_point_outside_its_block_stays_fixed_whatever_is_excavated) {
  Blocks blocks = two();
  blocks.fixed_points = {{{0.5, -0.03}, 0, {}}, {{0.5, 1.03}, 0, {}}};
  const ChangedBlocks far = without(blocks, {3, 0.5}, {5, 2});
  EXPECT_EQ(far.fixed_points, (std::vector{0, 1}));
  const ChangedBlocks half = without(blocks, {-1, 0.5}, {5, 2});  // takes the upper half
  ASSERT_EQ(half.fixed_points, (std::vector{0}));
  EXPECT_EQ(half.blocks.fixed_points[0].position.y, -0.03);
}

TEST(ChangeBlocks, a_bolt_at_the_wall_of_an_excavation_stays) {
  Blocks blocks = two();
  blocks.bolts.push_back({{{1, 0.5 - 1e-13}, {3, 0.25}}, 0, 1, 1e6, 0, 0, {}, {}});
  blocks.bolts.push_back({{{1, 0.75}, {3, 0.25}}, 0, 1, 1e6, 0, 0, {}, {}});
  const ChangedBlocks cut = without(blocks, {-1, 0.5}, {5, 2});
  EXPECT_EQ(cut.bolts, (std::vector{0}));
}

// An outline along the edges of blocks, as stages that share a line have it. Turned, it meets them within rounding
// alone, and once left a hair of rock along the wall, whose contacts were nonsense.
TEST(ChangeBlocks, an_outline_along_edges_leaves_whole_blocks_however_it_is_turned) {
  for (int degrees = 0; degrees < 90; ++degrees)
    for (const double far : {0.0, 1e4}) {
      const auto placed = [&](Point p) {
        const double a = degrees * std::numbers::pi / 180;
        return Point{far + std::cos(a) * p.x - std::sin(a) * p.y, far + std::sin(a) * p.x + std::cos(a) * p.y};
      };
      Blocks blocks = two();
      for (BlockPolygon& block : blocks.blocks)
        for (BlockVertex& corner : block.outer) corner.position = placed(corner.position);
      const Region region{{placed({1.5, 0}), placed({2.01, 0}), placed({2.01, 1}), placed({1.5, 1})}, 0};
      const ChangedBlocks cut = without_regions(blocks, std::array{region});
      ASSERT_EQ(cut.blocks.blocks.size(), 2U) << degrees;
      for (const BlockPolygon& block : cut.blocks.blocks) EXPECT_EQ(block.outer.size(), 4U) << degrees << ", " << far;
    }
}

TEST(ChangeBlocks, a_point_in_a_sliver_goes_to_the_rock_beside_it) {
  Blocks blocks = two();
  blocks.fixed_points = {{{0.5, 0.999}, 0, {}}};
  const ChangedBlocks cut =
      cut_along(blocks, std::vector<JointLine>{{{{0, 0.998}, {2, 0.998}}, 0, {}}, {{{0, 0.5}, {2, 0.5}}, 0, {}}});
  ASSERT_EQ(cut.fixed_points, (std::vector{0}));
  EXPECT_EQ(cut.blocks.fixed_points[0].position.y, 0.999);
}

}  // namespace
}  // namespace keyblock
