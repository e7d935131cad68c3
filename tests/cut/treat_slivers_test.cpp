// Glued slivers leave the rock unchanged except for the joint to their neighbour; omitted ones leave a gap. Areas and
// outlines are those of the drawing, by hand.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/bodies/treat_slivers.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cut/bodies/place_points.hpp"
#include "cut/bodies/slivers.hpp"
#include "geometry/segment.hpp"
#include "tests/cut/drawings.hpp"
#include "tests/validate/dice.hpp"

namespace keyblock::treat_slivers_test {
namespace {

/// Its four sides have the joint materials 4n to 4n + 3: lower, right, upper, left.
BlockPolygon box(Point low, Point high, int n) {
  return {n, {{low, 4 * n + 3}, {{high.x, low.y}, 4 * n}, {high, 4 * n + 1}, {{low.x, high.y}, 4 * n + 2}}, {}};
}

/// A floor, a block of height 1, a sliver of 0.01 × 1 at its right, and a block of height 0.8 at the right of that.
Blocks row_with_sliver() {
  Blocks blocks;
  blocks.blocks = {box({0, 0}, {4, 1}, 0), box({0, 1}, {2, 2}, 1), box({2, 1}, {2.01, 2}, 2),
                   box({2.01, 1}, {4, 1.8}, 3)};
  blocks.place = {"row.blk", 1, 1};
  return blocks;
}

CutResult treated(const Blocks& blocks, Slivers slivers) {
  return with_slivers_treated({blocks, {}, {}, {}}, slivers);
}

int material_at(const BlockPolygon& block, Point middle) {
  const BlockLoop& loop = block.outer;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Segment side{loop[(i + loop.size() - 1) % loop.size()].position, loop[i].position};
    if (distance(side, middle) < 1e-12) return loop[i].joint_material;
  }
  return -1;
}

std::string refusal(const Blocks& blocks, Slivers slivers) {
  try {
    treated(blocks, slivers);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

// A fixed base below a wall: gluing it to a brick would hold that brick.
TEST(TreatSlivers, a_long_slab_larger_than_the_mean_block_is_none) {
  Blocks blocks;
  blocks.blocks = {box({0, 0}, {102, 2}, 0)};
  for (int i = 0; i < 10; ++i) blocks.blocks.push_back(box({10.0 * i, 2}, {10.0 * (i + 1), 5}, i + 1));
  EXPECT_EQ(treated(blocks, Slivers::glued).blocks.blocks.size(), 11U);
}

TEST(TreatSlivers, a_sliver_goes_to_the_neighbour_with_the_longest_common_side) {
  const CutResult cut = treated(row_with_sliver(), Slivers::glued);
  ASSERT_EQ(cut.blocks.blocks.size(), 3U);
  const BlockPolygon& wide = cut.blocks.blocks[1];
  EXPECT_TRUE(is_same_loop(
      wide.outer, {{{0, 1}, 0}, {{2, 1}, 0}, {{2.01, 1}, 0}, {{2.01, 2}, 0}, {{2, 2}, 0}, {{0, 2}, 0}}, 1e-15));
  EXPECT_EQ(wide.material, 1);
  EXPECT_EQ(material_at(wide, {2.01, 1.5}), 4 * 2 + 1);
  EXPECT_EQ(material_at(wide, {2.005, 2}), 4 * 2 + 2);
  EXPECT_EQ(material_at(wide, {1, 2}), 4 * 1 + 2);
  EXPECT_NEAR(area(wide), 2.01, 1e-15);
  EXPECT_EQ(cut.blocks.blocks[2], row_with_sliver().blocks[3]);
  ASSERT_EQ(cut.warnings.size(), 1U);
  EXPECT_EQ(cut.warnings[0].name, "slivers_glued");
  // 0.01 of 4 + 2 + 0.01 + 1.99 · 0.8
  EXPECT_NE(cut.warnings[0].sentence.find("1 block of 4, 0.13 % of all area, is a sliver"), std::string::npos)
      << cut.warnings[0].sentence;
  EXPECT_NE(cut.warnings[0].sentence.find("2.005, 1.5 (area 0.01)"), std::string::npos) << cut.warnings[0].sentence;
}

TEST(TreatSlivers, corners_left_straight_go_where_the_joint_is_the_same) {
  Blocks blocks = row_with_sliver();
  for (BlockPolygon& block : blocks.blocks)
    for (BlockVertex& vertex : block.outer) vertex.joint_material = 0;
  const CutResult cut = treated(blocks, Slivers::glued);
  EXPECT_TRUE(is_same_loop(cut.blocks.blocks[1].outer, box({0, 1}, {2.01, 2}, 0).outer, 1e-15));
}

// A plate on the middle of the floor's upper side: the side is cut in three.
TEST(TreatSlivers, a_sliver_on_the_middle_of_a_side_is_glued_to_it) {
  Blocks blocks;
  blocks.blocks = {box({0, 0}, {4, 1}, 0), box({1, 1}, {2, 1.01}, 1)};
  const CutResult cut = treated(blocks, Slivers::glued);
  ASSERT_EQ(cut.blocks.blocks.size(), 1U);
  EXPECT_EQ(cut.blocks.blocks[0].outer.size(), 8U);
  EXPECT_NEAR(area(cut.blocks.blocks[0]), 4.01, 1e-14);
  EXPECT_EQ(material_at(cut.blocks.blocks[0], {0.5, 1}), 2);
  EXPECT_EQ(material_at(cut.blocks.blocks[0], {1.5, 1.01}), 4 + 2);
}

TEST(TreatSlivers, a_chain_of_slivers_goes_to_one_block) {
  Blocks blocks;
  blocks.blocks = {box({0, 0}, {2, 2}, 0), box({2, 0}, {2.01, 2}, 1), box({2.01, 0}, {2.02, 2}, 2)};
  const CutResult cut = treated(blocks, Slivers::glued);
  ASSERT_EQ(cut.blocks.blocks.size(), 1U);
  EXPECT_NEAR(area(cut.blocks.blocks[0]), 4.04, 1e-14);
  EXPECT_EQ(cut.blocks.blocks[0].material, 0);
  EXPECT_NE(cut.warnings[0].sentence.find("2 blocks of 3, 0.99 % of all area, are slivers"), std::string::npos)
      << cut.warnings[0].sentence;
}

// A C-shaped block, whose mouth the sliver closes around another block.
TEST(TreatSlivers, a_sliver_that_closes_a_ring_leaves_a_hole_in_it) {
  Blocks blocks;
  const BlockLoop letter{{{0, 0}, 0}, {{3, 0}, 0}, {{3, 1}, 0}, {{1, 1}, 0},
                         {{1, 2}, 0}, {{3, 2}, 0}, {{3, 3}, 0}, {{0, 3}, 0}};
  blocks.blocks = {{0, letter, {}}, box({1.2, 1.2}, {2.5, 1.8}, 1), box({2.98, 1}, {3, 2}, 2)};
  const CutResult cut = treated(blocks, Slivers::glued);
  ASSERT_EQ(cut.blocks.blocks.size(), 2U);
  ASSERT_EQ(cut.blocks.blocks[0].holes.size(), 1U);
  EXPECT_NEAR(area(cut.blocks.blocks[0]), 7.02, 1e-14);
  EXPECT_NEAR(area(points_of(cut.blocks.blocks[0].holes[0])), -1.98, 1e-14);
}

TEST(TreatSlivers, points_and_bolts_go_along) {
  Blocks blocks = row_with_sliver();
  blocks.fixed_points = {{{2.005, 1.5}, 2, {}}, {{3, 1.5}, 3, {}}};
  blocks.loading_points = {{{2.005, 1.2}, 2, {}}};
  blocks.measured_points = {{{1, 1.5}, 1, {}}, {{3, 0.5}, 0, {}}};
  blocks.bolts = {{{{2.005, 1.5}, {3, 1.5}}, 2, 3, 1, 0, 0, {}}, {{{1, 1.5}, {2.005, 1.5}}, 1, 2, 1, 0, 0, {}}};
  const CutResult cut = treated(blocks, Slivers::glued);
  for (const std::vector<BlockPoint>* points :
       {&cut.blocks.fixed_points, &cut.blocks.loading_points, &cut.blocks.measured_points})
    for (const BlockPoint& point : *points)
      EXPECT_TRUE(holds(cut.blocks.blocks[static_cast<std::size_t>(point.block)], point.position)) << point.position.x;
  EXPECT_EQ(cut.blocks.fixed_points.size(), 2U);
  EXPECT_EQ(cut.blocks.bolts[0].first_block, 1);
  EXPECT_EQ(cut.blocks.bolts[0].second_block, 2);
  EXPECT_TRUE(has_warning(cut.warnings, "bolt_in_one_block"));
}

TEST(TreatSlivers, one_that_touches_no_side_stays_and_is_told) {
  Blocks blocks = row_with_sliver();
  blocks.blocks.push_back(box({9, 9}, {9.01, 9.01}, 4));
  const CutResult cut = treated(blocks, Slivers::glued);
  ASSERT_EQ(cut.blocks.blocks.size(), 4U);
  EXPECT_EQ(cut.blocks.blocks[3], blocks.blocks[4]);
  EXPECT_NE(cut.warnings[0].sentence.find("1 more shares no side with another and stays"), std::string::npos)
      << cut.warnings[0].sentence;
}

TEST(TreatSlivers, left_out_they_are_not_there) {
  Blocks blocks = row_with_sliver();
  blocks.fixed_points = {{{3, 1.5}, 3, {}}};
  const CutResult cut = treated(blocks, Slivers::left_out);
  ASSERT_EQ(cut.blocks.blocks.size(), 3U);
  EXPECT_EQ(cut.blocks.blocks[2], blocks.blocks[3]);
  EXPECT_EQ(cut.blocks.fixed_points[0].block, 2);
  EXPECT_TRUE(has_warning(cut.warnings, "slivers_left_out"));
}

TEST(TreatSlivers, none_is_left_out_that_carries_something) {
  const std::string at = "at 2.005, 1.5 in the one at 2.005, 1.5 (area 0.01); slivers=glue keeps it";
  const auto with = [](const auto& change) {
    Blocks blocks = row_with_sliver();
    change(blocks);
    return refusal(blocks, Slivers::left_out);
  };
  const BlockPoint point{{2.005, 1.5}, 2, {"row.blk", 7, 3}};
  EXPECT_EQ(
      with([&](Blocks& blocks) { blocks.fixed_points = {point}; }),
      "row.blk:7:3: error: expected a fixed point in a block that is no sliver under slivers=leave_out, found it " +
          at);
  EXPECT_NE(with([&](Blocks& blocks) { blocks.loading_points = {point}; }).find("a loading point"), std::string::npos);
  EXPECT_NE(with([&](Blocks& blocks) { blocks.measured_points = {point}; }).find("a measured point"),
            std::string::npos);
  EXPECT_NE(with([&](Blocks& blocks) {
              blocks.bolts = {{{{1, 1.5}, {2.005, 1.5}}, 1, 2, 1, 0, 0, {}}};
            }).find("the end of a bolt"),
            std::string::npos);
  EXPECT_EQ(with([](Blocks&) {}), "");
}

TEST(TreatSlivers, not_all_blocks_are_left_out) {
  Blocks blocks;
  blocks.blocks = {box({0, 0}, {2, 0.01}, 0), box({0, 0.01}, {2, 0.02}, 1)};
  EXPECT_NE(refusal(blocks, Slivers::left_out).find("expected a block that is no sliver"), std::string::npos);
}

TEST(TreatSlivers, without_slivers_the_setting_says_so) {
  Blocks blocks;
  blocks.blocks = {box({0, 0}, {4, 1}, 0), box({0, 1}, {2, 2}, 1)};
  const CutResult cut = treated(blocks, Slivers::glued);
  EXPECT_EQ(cut.blocks.blocks, blocks.blocks);
  EXPECT_TRUE(has_warning(cut.warnings, "setting_without_effect"));
  EXPECT_TRUE(treated(row_with_sliver(), Slivers::kept).warnings.empty());
}

// Random joints across a square: as much rock as before, and every remaining side was a side of the same joint.
TEST(TreatSlivers, random_drawings_keep_their_area_and_their_joints) {
  Dice dice(71);
  int glued = 0;
  for (int tries = 0; tries < 60; ++tries) {
    std::vector<Segment> lines = rectangle_sides({0, 0}, {1, 1});
    for (int i = 0; i < 12; ++i) {
      const double from = dice.between(0, 1);
      const double to = dice.between(0, 1);
      lines.push_back(i % 2 == 0 ? Segment{{from, 0}, {to, 1}} : Segment{{0, from}, {1, to}});
    }
    const CutResult before = cut_blocks(drawing_of(lines, tries % 2 == 0 ? 0 : 1e-3));
    const CutResult after = with_slivers_treated(before, Slivers::glued);
    glued += static_cast<int>(before.blocks.blocks.size() - after.blocks.blocks.size());
    EXPECT_NEAR(total_area(after.blocks), total_area(before.blocks), 1e-12) << tries;
    const double mean = total_area(after.blocks) / static_cast<double>(after.blocks.blocks.size());
    std::size_t corner = 0;
    for (const BlockPolygon& block : after.blocks.blocks) {
      EXPECT_FALSE(is_sliver(form_of(block), mean)) << tries;
      const double off = tries % 2 == 0 ? 1e-12 : 1e-2;  // near crossings become one node
      for (std::size_t i = 0; i < block.outer.size(); ++i, ++corner) {
        const int line = after.joint_lines[corner];
        EXPECT_EQ(block.outer[i].joint_material, line);  // joint materials number the lines
        const Point last = block.outer[(i + block.outer.size() - 1) % block.outer.size()].position;
        EXPECT_LT(distance(lines[static_cast<std::size_t>(line)], 0.5 * (last + block.outer[i].position)), off);
      }
      for (const BlockLoop& hole : block.holes) corner += hole.size();
    }
    EXPECT_EQ(corner, after.joint_lines.size());
  }
  EXPECT_GT(glued, 200);
}

}  // namespace keyblock::treat_slivers_test
