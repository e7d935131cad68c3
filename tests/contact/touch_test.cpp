// Which corners meet which edges, for the ways two convex blocks can face each other.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/touch.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "model/kinematics.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock {
namespace {

using testing::rectangle;

Touches touches_between(const BlockPolygon& a, const BlockPolygon& b, const TouchSearch& search = {0.1}) {
  Blocks blocks;
  blocks.blocks = {a, b};
  const Model model = model_from_blocks(blocks, testing::plain_analysis(1, 1));
  const Table<ElementIndex, ConvexPieces> pieces{convex_pieces(model, {0}), convex_pieces(model, {1})};
  Table<VertexIndex, Point> vertices;
  vertices.assign(model.start_vertices.begin(), model.start_vertices.end());
  Touches touches = find_touches({{{0}, {1}}}, pieces, vertices, search).touches;
  std::ranges::sort(touches);
  return touches;
}

BlockPolygon square_on_corner(Point corner) {
  BlockPolygon block = rectangle({0, 0}, {1, 1});
  for (BlockVertex& v : block.outer) v.position = corner + turned(v.position, 0.6);
  return block;
}

}  // namespace

// Vertices of a rectangle: 0 low left, 1 low right, 2 high right, 3 high left; block b starts at 4.
TEST(Touch, both_lower_corners_of_a_block_meet_the_floor) {
  const Touches found = touches_between(rectangle({0, -1}, {5, 0}), rectangle({1, 0}, {2, 1}));
  EXPECT_EQ(found, (Touches{{{4}, {2}, {3}}, {{5}, {2}, {3}}}));
}

TEST(Touch, an_overhanging_block_meets_the_end_of_the_floor) {
  const Touches found = touches_between(rectangle({0, -1}, {5, 0}), rectangle({4.5, 0}, {5.5, 1}));
  EXPECT_EQ(found, (Touches{{{2}, {4}, {5}}, {{4}, {2}, {3}}}));
}

TEST(Touch, a_block_on_its_corner_meets_the_floor_with_that_corner) {
  const Touches found = touches_between(rectangle({-5, -1}, {5, 0}), square_on_corner({0, 0}));
  EXPECT_TRUE(std::ranges::find(found, Touch{{4}, {2}, {3}}) != found.end());
}

TEST(Touch, blocks_out_of_reach_or_past_each_other_do_not_meet) {
  EXPECT_TRUE(touches_between(rectangle({0, -1}, {5, 0}), rectangle({1, 0.2}, {2, 1})).empty());
  EXPECT_TRUE(touches_between(rectangle({0, -1}, {5, 0}), rectangle({5.05, 0.01}, {6, 1})).empty());
}

// Springs give by up to 2 mm; the block leans by 4e-4 and its corner hangs over the end of the floor by 1 mm.
TEST(Touch, a_block_that_leans_on_its_springs_is_no_corner) {
  BlockPolygon leaning = rectangle({1.001, 0}, {5.001, 8});
  leaning.outer[0].position.y = -0.0002;
  leaning.outer[1].position.y = -0.0018;
  const Touches found = touches_between(rectangle({0, -1}, {5, 0}), leaning, {0.1, 0.004});
  EXPECT_EQ(found, (Touches{{{2}, {4}, {5}}, {{4}, {2}, {3}}}));
}

// An L: floor and wall in one block, cut from its reflex corner (vertex 3). A block in the corner rests on both.
TEST(Touch, a_block_in_the_corner_of_an_l_meets_its_floor_and_its_wall) {
  const BlockPolygon l{0, {{{0, 0}, 0}, {{5, 0}, 0}, {{5, 1}, 0}, {{1, 1}, 0}, {{1, 4}, 0}, {{0, 4}, 0}}, {}};
  const Touches found = touches_between(l, rectangle({1, 1}, {2, 2}));
  const Touch on_floor{{7}, {2}, {3}};
  const Touch on_wall{{9}, {3}, {4}};
  EXPECT_TRUE(std::ranges::find(found, on_floor) != found.end());
  EXPECT_TRUE(std::ranges::find(found, on_wall) != found.end());
  for (const Touch& touch : found)
    EXPECT_TRUE(touch.start == VertexIndex{2} || touch.start == VertexIndex{3} || touch.start.value > 5);
}

}  // namespace keyblock
