// Fixed lines become points inside blocks; points, bolts, holes and materials find their blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/bodies/place_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cut/bodies/cut_blocks.hpp"
#include "tests/cut/drawings.hpp"

namespace keyblock::place_points_test {
namespace {

/// Two unit squares side by side, the right one numbered first; w0 = 1.02 / 1.3.
Drawing two_squares() {
  return drawing_of(rectangle_sides({0, 0}, {2, 1}) + std::vector<Segment>{{{1, 0}, {1, 1}}});
}

constexpr double kInset = 0.005 * 1.02 / 1.3;

}  // namespace

TEST(PlacePoints, a_fixed_line_gives_a_point_inside_each_edge_it_crosses) {
  Drawing drawing = two_squares();
  drawing.fixed_lines = {{{{0.5, 0.5}, {1.5, 0.5}}, {}}};
  const Blocks blocks = cut_blocks(drawing).blocks;
  ASSERT_EQ(blocks.fixed_points.size(), 2U);
  for (const BlockPoint& p : blocks.fixed_points) {
    EXPECT_NEAR(std::fabs(p.position.x - 1), kInset, 1e-15);
    EXPECT_TRUE(holds(blocks.blocks[p.block], p.position));
  }
}

TEST(PlacePoints, a_fixed_line_that_crosses_nothing_is_its_first_end) {
  Drawing drawing = two_squares();
  drawing.fixed_lines = {{{{1.2, 0.5}, {1.5, 0.5}}, {}}, {{{0.3, 0.3}, {0.3, 0.3}}, {}}};
  const Blocks blocks = cut_blocks(drawing).blocks;
  ASSERT_EQ(blocks.fixed_points.size(), 2U);
  EXPECT_EQ(blocks.fixed_points[0].position, (Point{1.2, 0.5}));
  EXPECT_EQ(blocks.fixed_points[1].position, (Point{0.3, 0.3}));
}

TEST(PlacePoints, a_point_on_a_common_vertex_goes_to_the_first_such_block) {
  Drawing drawing = two_squares();
  drawing.measured_points = {{{1, 0}, {}}, {{1 + 1e-6, 1}, {}}, {{1, 0.5}, {}}};
  const Blocks blocks = cut_blocks(drawing).blocks;
  ASSERT_EQ(blocks.measured_points.size(), 3U);
  for (const BlockPoint& p : blocks.measured_points) EXPECT_EQ(p.block, 0);
}

TEST(PlacePoints, a_point_outside_is_left_out_with_its_place) {
  Drawing drawing = two_squares();
  drawing.measured_points = {{{5, 5}, {"drawing", 42, 3}}, {{0.5, 0.5}, {}}};
  const CutResult cut = cut_blocks(drawing);
  EXPECT_EQ(cut.blocks.measured_points.size(), 1U);
  ASSERT_EQ(cut.warnings.size(), 1U);
  EXPECT_EQ(cut.warnings[0].name, "point_outside_blocks");
  EXPECT_EQ(cut.warnings[0].place.line, 42);
}

// A point such as r·cos lies off a face by round-off, half of them outside.
TEST(PlacePoints, marks_on_a_slanted_face_are_held_whatever_the_last_digit_says) {
  Drawing drawing = drawing_of({{{-6, -4}, {18, -4}},
                                {{18, -4}, {18, 10}},
                                {{18, 10}, {3.6397023426620243, 10}},
                                {{3.6397023426620243, 10}, {0, 0}},
                                {{0, 0}, {-6, 0}},
                                {{-6, 0}, {-6, -4}},
                                {{-1, 0.5}, {18, 9.5}}});
  const double tangent = std::tan(20 * std::numbers::pi / 180);
  for (int i = 1; i < 40; ++i) {
    const Point head{0.25 * i * tangent, 0.25 * i};
    drawing.bolts.push_back({{head, head + Point{5, -0.8}}, 1e7, 1e5, 0, 0, {}});
    drawing.measured_points.push_back({head, {}});
    drawing.loading_points.push_back({head, {}});
    drawing.fixed_lines.push_back({{head, head}, {}});
  }
  const CutResult cut = cut_blocks(drawing);
  EXPECT_EQ(cut.blocks.bolts.size(), 39U);
  EXPECT_EQ(cut.blocks.measured_points.size(), 39U);
  EXPECT_EQ(cut.blocks.loading_points.size(), 39U);
  EXPECT_EQ(cut.blocks.fixed_points.size(), 39U);
  EXPECT_FALSE(has_warning(cut.warnings, "point_outside_blocks"));
  EXPECT_FALSE(has_warning(cut.warnings, "points_moved")) << "round-off gives no message";
}

TEST(PlacePoints, a_mark_within_the_merging_distance_is_moved_onto_the_block_and_said) {
  Drawing drawing = two_squares();
  drawing.edge_node_ratio = 0.01;
  const double merge = cut_tolerances(drawing).merge;
  drawing.measured_points = {{{0.5, -0.9 * merge}, {}}, {{0.5, -1.1 * merge}, {"drawing", 7, 1}}};
  const CutResult cut = cut_blocks(drawing);
  ASSERT_EQ(cut.blocks.measured_points.size(), 1U);
  EXPECT_EQ(cut.blocks.measured_points[0].position, (Point{0.5, 0}));
  EXPECT_TRUE(has_warning(cut.warnings, "points_moved"));
  EXPECT_TRUE(has_warning(cut.warnings, "point_outside_blocks"));
}

TEST(PlacePoints, many_marks_outside_and_idle_bolts_are_one_warning_each_with_their_number) {
  Drawing drawing = two_squares();
  for (int i = 0; i < 60; ++i) drawing.bolts.push_back({{{5.0 + i, 5}, {5.0 + i, 6}}, 1e6, 0, 0, 0, {}});
  for (int i = 0; i < 30; ++i) drawing.bolts.push_back({{{0.1, 0.01 * i + 0.1}, {0.2, 0.1}}, 1e6, 0, 0, 0, {}});
  drawing.measured_points = {{{9, 9}, {}}};
  const CutResult cut = cut_blocks(drawing);
  ASSERT_EQ(cut.warnings.size(), 2U);
  EXPECT_EQ(cut.warnings[0].name, "point_outside_blocks");
  EXPECT_NE(cut.warnings[0].sentence.find("121 marks (1 × measured point, 120 × bolt end) lie outside"),
            std::string::npos)
      << cut.warnings[0].sentence;
  EXPECT_NE(cut.warnings[1].sentence.find("both ends of 30 bolts"), std::string::npos) << cut.warnings[1].sentence;
}

// Loads belong to loading points by their order.
TEST(PlacePoints, a_loading_point_outside_is_an_error) {
  Drawing drawing = two_squares();
  drawing.loading_points = {{{5, 5}, {"drawing", 42, 3}}, {{0.5, 0.5}, {}}};
  EXPECT_THROW(cut_blocks(drawing), InputError);
}

TEST(PlacePoints, a_hole_point_removes_its_block_before_points_are_placed) {
  Drawing drawing = two_squares();
  drawing.hole_points = {{{0.5, 0.5}, {}}};
  drawing.measured_points = {{{1.5, 0.5}, {}}};
  const Blocks blocks = cut_blocks(drawing).blocks;
  ASSERT_EQ(blocks.blocks.size(), 1U);
  ASSERT_EQ(blocks.measured_points.size(), 1U);
  EXPECT_EQ(blocks.measured_points[0].block, 0);
}

TEST(PlacePoints, a_point_in_a_hole_belongs_to_the_block_within) {
  Drawing drawing = drawing_of(rectangle_sides({0, 0}, {9, 9}) + rectangle_sides({3, 3}, {6, 6}));
  drawing.measured_points = {{{4, 4}, {}}, {{1, 1}, {}}};
  const Blocks blocks = cut_blocks(drawing).blocks;
  EXPECT_EQ(blocks.measured_points.at(0).block, 1);
  EXPECT_EQ(blocks.measured_points.at(1).block, 0);
}

TEST(PlacePoints, the_later_material_line_wins) {
  Drawing drawing = two_squares();
  drawing.material_lines = {{{{0.5, 0.5}, {1.5, 0.5}}, 2, {}}, {{{1.2, 0.2}, {1.3, 0.3}}, 4, {}}};
  const Blocks blocks = cut_blocks(drawing).blocks;
  EXPECT_EQ(blocks.blocks[0].material, 4);
  EXPECT_EQ(blocks.blocks[1].material, 2);
}

// The box of the diagonal holds the point, the diagonal does not.
TEST(PlacePoints, a_material_line_that_is_a_point_gives_its_material_to_the_one_block_that_holds_it) {
  Drawing drawing = drawing_of(rectangle_sides({0, 0}, {10, 10}) + std::vector<Segment>{{{0, 0}, {10, 10}}});
  drawing.material_lines = {{{{8, 3}, {8, 3}}, 2, {}}};
  int taken = 0;
  for (const BlockPolygon& block : cut_blocks(drawing).blocks.blocks) taken += block.material == 2 ? 1 : 0;
  EXPECT_EQ(taken, 1);
}

TEST(PlacePoints, a_bolt_joins_the_blocks_of_its_ends) {
  Drawing drawing = two_squares();
  drawing.bolts = {{{{0.5, 0.5}, {1.5, 0.5}}, 1e6, 2, 3, 0, {}}, {{{0.5, 0.5}, {7, 7}}, 1e6, 2, 3, 0, {}}};
  const CutResult cut = cut_blocks(drawing);
  ASSERT_EQ(cut.blocks.bolts.size(), 1U);
  EXPECT_EQ(cut.blocks.bolts[0].first_block, 1);
  EXPECT_EQ(cut.blocks.bolts[0].second_block, 0);
  EXPECT_TRUE(has_warning(cut.warnings, "point_outside_blocks"));
}

}  // namespace keyblock::place_points_test
