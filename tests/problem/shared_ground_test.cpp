// Blocks in one place and holes outside their blocks are reported; neighbours and joints as wide as the tolerance of a
// cutter are not.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/checks/shared_ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace keyblock::shared_ground_test {
namespace {

BlockPolygon rectangle(Point low, Point high) {
  return {0, {{low, 0}, {{high.x, low.y}, 0}, {high, 0}, {{low.x, high.y}, 0}}, {}};
}

Blocks of(std::vector<BlockPolygon> polygons) {
  Blocks blocks;
  blocks.blocks = std::move(polygons);
  blocks.place = {"b"};
  return blocks;
}

std::string sentence_of(const Blocks& blocks) {
  const Warnings warnings = shared_ground(blocks);
  return warnings.empty() ? "" : warnings.front().sentence;
}

}  // namespace

TEST(SharedGround, the_first_pair_is_named_with_its_share_and_the_number_of_all) {
  const BlockPolygon block = rectangle({1, 0}, {2, 1});
  const Blocks blocks = of({rectangle({0, -1}, {10, 0.25}), block, block, block});
  EXPECT_EQ(
      sentence_of(blocks),
      "block 2 lies in block 1 by 25 % of the smaller one; so do 5 other pairs: contact drives them apart, or lets "
      "them be");
}

TEST(SharedGround, neighbours_and_overlaps_of_a_cutter_are_not_told) {
  EXPECT_EQ(sentence_of(of({rectangle({0, 0}, {1, 1}), rectangle({1, 0}, {2, 1}), rectangle({0, 1}, {2, 2})})), "");
  EXPECT_EQ(sentence_of(of({rectangle({0, 0}, {1, 1}), rectangle({0.995, 0}, {2, 1})})), "");
}

// 3,000 blocks in one place are 4.5 million pairs.
TEST(SharedGround, of_very_many_pairs_a_thousand_are_counted) {
  const std::string sentence = sentence_of(of(std::vector<BlockPolygon>(3000, rectangle({0, 0}, {1, 1}))));
  EXPECT_NE(sentence.find("so do at least 999 other pairs"), std::string::npos) << sentence;
}

namespace {

BlockPolygon polygon(const std::vector<Point>& corners) {
  BlockPolygon block;
  for (const Point p : corners) block.outer.push_back({p, 0});
  return block;
}

}  // namespace

TEST(SharedGround, an_outline_that_crosses_itself_is_refused_with_its_two_edges) {
  BlockPolygon block = polygon({{1, 0}, {2, 1}, {2, 0}, {1, 1.5}});
  block.place = {"b", 4, 3};
  const auto errors = crossed_outlines(of({rectangle({0, -1}, {4, 0}), block}));
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_STREQ(errors.front().what(),
               "b:4:3: error: expected edges of block 2 of 2 that do not cross, found edge 1 from (1, 0) to (2, 1) "
               "across edge 3 from (2, 0) to (1, 1.5) at (1.6, 0.6)");
  BlockPolygon with_hole = rectangle({0, 0}, {4, 4});
  with_hole.holes = {polygon({{1, 1}, {2, 2}, {2, 1}, {1, 2}}).outer};
  const auto of_hole = crossed_outlines(of({with_hole}));
  ASSERT_EQ(of_hole.size(), 1U);
  EXPECT_NE(std::string(of_hole.front().what()).find("edge 1 of hole 1 from (1, 1) to (2, 2) across edge 3 of hole 1"),
            std::string::npos)
      << of_hole.front().what();
}

TEST(SharedGround, of_holes_in_one_place_the_second_is_refused) {
  BlockPolygon block = rectangle({0, 0}, {9, 9});
  const auto hole = [](Point low, Point high) {
    BlockLoop loop = rectangle(low, high).outer;
    std::ranges::reverse(loop);
    return loop;
  };
  block.holes = {hole({1, 1}, {3, 3}), hole({4, 4}, {6, 6})};
  EXPECT_TRUE(misplaced_holes(of({block})).empty());
  for (const BlockLoop& other : {hole({1, 1}, {3, 3}), hole({1.5, 1.5}, {2, 2}), hole({0.5, 0.5}, {3.5, 3.5})}) {
    block.holes[1] = other;
    EXPECT_EQ(misplaced_holes(of({block})).size(), 1U);
  }
}

TEST(SharedGround, a_hole_lies_in_its_block_and_turns_the_other_way) {
  const auto with_hole = [](BlockLoop hole) {
    BlockPolygon block = rectangle({0, 0}, {4, 4});
    block.place = {"b", 3, 5};
    block.holes = {std::move(hole)};
    return of({block});
  };
  BlockLoop hole = rectangle({1, 1}, {3, 3}).outer;
  const auto turned_wrongly = misplaced_holes(with_hole(hole));
  ASSERT_EQ(turned_wrongly.size(), 1U);
  EXPECT_STREQ(turned_wrongly.front().what(),
               "b:3:5: error: expected hole 1 of block 1 clockwise with an area, found area 4");
  std::ranges::reverse(hole);
  EXPECT_TRUE(misplaced_holes(with_hole(hole)).empty());
  for (BlockVertex& vertex : hole) vertex.position.x += 2.5;
  const auto outside = misplaced_holes(with_hole(hole));
  ASSERT_EQ(outside.size(), 1U);
  EXPECT_NE(std::string(outside.front().what()).find("within its outer loop, found a corner of it at (5.5, 3)"),
            std::string::npos)
      << outside.front().what();
}

// A spike without width hides the face on which a block lies.
TEST(SharedGround, outlines_that_come_back_along_an_edge_are_refused) {
  const auto errors_of = [](const std::vector<Point>& corners, double scale, Point at) {
    BlockPolygon block;
    for (const Point p : corners) block.outer.push_back({at + scale * p, 0});
    return crossed_outlines(of({block}));
  };
  const std::vector<Point> spiked{{1, 1}, {2, 1}, {2, 2}, {3, 2}, {2, 2}, {1, 2}};
  const std::vector<Point> short_spike{{1, 1}, {2, 1}, {2.01, 1}, {2, 1}, {2, 2}, {1, 2}};
  const std::vector<Point> back_past_start{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {3, 1}, {0, 2}};
  const std::vector<Point> thin{{0, 0}, {2, 0}, {2, 1}, {3, 1.0001}, {2, 1.0002}, {2, 2}, {0, 2}};
  const std::vector<Point> in_line{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}};
  for (const double scale : {1e-3, 1.0, 1e3})
    for (const Point at : {Point{0, 0}, Point{1e3 * scale, -5e3 * scale}}) {
      for (const auto& outline : {spiked, short_spike, back_past_start})
        EXPECT_FALSE(errors_of(outline, scale, at).empty()) << scale << " " << at.x;
      for (const auto& outline : {thin, in_line}) EXPECT_TRUE(errors_of(outline, scale, at).empty()) << scale;
    }
  EXPECT_NE(errors_of(spiked, 1, {}).front().sentence().find("which comes back along it"), std::string::npos);
}

}  // namespace keyblock::shared_ground_test
