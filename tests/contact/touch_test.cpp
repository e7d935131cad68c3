// Corners and edges in contact, for the ways in which two convex blocks can face each other.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/find/touch.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "model/kinematics.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::touch_test {
namespace {

using support::rectangle;

constexpr double kReach = 0.1;

Model two_blocks(const BlockPolygon& a, const BlockPolygon& b) {
  Blocks blocks;
  blocks.blocks = {a, b};
  return model_from_blocks(blocks, support::plain_analysis(1, 1));
}

Table<VertexIndex, Point> vertices_of(const Model& model) {
  Table<VertexIndex, Point> vertices;
  vertices.assign(model.start_vertices.begin(), model.start_vertices.end());
  return vertices;
}

FoundTouches found_between(const BlockPolygon& a, const BlockPolygon& b, const TouchSearch& search = {kReach}) {
  const Model model = two_blocks(a, b);
  const Table<ElementIndex, ConvexPieces> pieces{convex_pieces(model, {0}), convex_pieces(model, {1})};
  return find_touches({{{0}, {1}}}, pieces, vertices_of(model), search);
}

Touches touches_between(const BlockPolygon& a, const BlockPolygon& b, const TouchSearch& search = {kReach}) {
  Touches touches = found_between(a, b, search).touches;
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

TEST(Touch, a_corner_past_the_end_of_the_floor_is_not_over_it) {
  const Touch left_corner_on_floor{{4}, {2}, {3}};
  for (const auto& [left, is_over] : {std::pair{4.9, true}, {5.0, true}, {5.1, false}, {-0.1, false}}) {
    const Model model = two_blocks(rectangle({0, -1}, {5, 0}), rectangle({left, 0}, {left + 1, 1}));
    EXPECT_EQ(lies_over_edge(left_corner_on_floor, vertices_of(model)), is_over) << left;
  }
}

// The tops of two floors are in line, and a block that slides along the first comes up to the end face of the second.
// An arc is there: it neither hits the end nor falls between.
TEST(Touch, a_block_that_slides_on_to_the_next_floor_does_not_hit_its_end) {
  const BlockPolygon floor = rectangle({4, -1}, {8, 0});
  const Table<ElementIndex, double> rounding{0.01, 0.01};
  TouchSearch search{kReach};
  search.rounding = &rounding;
  const FoundTouches found = found_between(floor, rectangle({2.95, 0}, {3.95, 1}), search);
  EXPECT_TRUE(found.touches.empty());
  ASSERT_EQ(found.meetings.size(), 1U);
  const auto gap_at = [&](double x, double y) {
    return gap_of(found.meetings[0].arc, vertices_of(two_blocks(floor, rectangle({x - 1, y}, {x, y + 1}))));
  };
  EXPECT_GT(gap_at(4, 0), 0.4 * 0.01);
  EXPECT_NEAR(gap_at(4.2, 0), 0, 1e-15);
  EXPECT_NEAR(gap_at(4.2, -0.001), -0.001, 1e-15);
  EXPECT_NEAR(gap_at(3.9, -0.5), 0.1, 1e-15);
}

// Springs give by up to 2 mm; the block leans by 4e-4 and its corner hangs over the end of the floor by 1 mm.
TEST(Touch, a_block_that_leans_on_its_springs_is_no_corner) {
  BlockPolygon leaning = rectangle({1.001, 0}, {5.001, 8});
  leaning.outer[0].position.y = -0.0002;
  leaning.outer[1].position.y = -0.0018;
  const Touches found = touches_between(rectangle({0, -1}, {5, 0}), leaning, {0.1, {0.004, 0.004}});
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

// The tip of a wedge is 0.1 mm past the foot of a slope, vertex 3, below the floor and on the line of the slope. The
// corners of the block below decide where the diagonal from the foot ends.
TEST(Touch, a_tip_past_a_reflex_corner_meets_the_floor) {
  for (const Point low_left : {Point{-4, -2}, Point{-1, -3}, Point{-0.5, -0.5}, Point{1, -3}})
    for (const double lean : {0.01, 0.2, 0.7}) {
      const BlockPolygon floor{0, {{low_left, 0}, {{6, -3}, 0}, {{4, 4}, 0}, {{0, 0}, 0}, {{-4, 0}, 0}}, {}};
      const Point tip{-1e-4, -1e-4}, side = turned(Point{2, 2}, lean);
      const BlockPolygon wedge{0, {{tip, 0}, {tip + side, 0}, {tip + turned(side, 0.3), 0}}, {}};
      const Touches found = touches_between(floor, wedge);
      EXPECT_TRUE(std::ranges::count(found, Touch{{5}, {3}, {4}}) == 1) << low_left.x << " " << lean;
      for (const Touch& touch : found) EXPECT_NE(touch.vertex, VertexIndex{3});
    }
}

// Both pieces of the floor reach beyond the foot: the wedge is on the slope too.
TEST(Touch, an_edge_goes_on_beyond_a_reflex_corner) {
  const BlockPolygon floor{0, {{{-4, -2}, 0}, {{6, -3}, 0}, {{4, 4}, 0}, {{0, 0}, 0}, {{-4, 0}, 0}}, {}};
  const BlockPolygon wedge{0, {{{-1e-4, -1e-4}, 0}, {{1, 2}, 0}, {{0, 2}, 0}}, {}};
  const Touches found = touches_between(floor, wedge);
  const auto on_slope = std::ranges::find(found, Touch{{5}, {2}, {3}});
  ASSERT_TRUE(on_slope != found.end());
  EXPECT_TRUE(lies_over_edge(*on_slope, vertices_of(two_blocks(floor, wedge))));
}

// A plank over a notch rests on its rims. The bottom of the notch is no point of contact.
TEST(Touch, a_plank_over_a_flat_notch_rests_on_the_rims) {
  const BlockPolygon notched{0, {{{0, -2}, 0}, {{4, -2}, 0}, {{4, 0}, 0}, {{2, -0.01}, 0}, {{0, 0}, 0}}, {}};
  const Touches found = touches_between(notched, rectangle({-1, 0}, {5, 1}));
  for (const Touch& touch : found) EXPECT_NE(touch.vertex, VertexIndex{3});
  for (const int rim : {2, 4}) EXPECT_TRUE(std::ranges::find(found, Touch{{rim}, {5}, {6}}) != found.end()) << rim;
}

}  // namespace keyblock::touch_test
