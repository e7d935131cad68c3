// Areas add up to the outline, blocks do not depend on the form of the lines, and irregular input is reported by name.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/bodies/cut_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "tests/cut/drawings.hpp"
#include "tests/validate/exact_arrangement.hpp"
#include "tests/validate/random_drawings.hpp"

namespace keyblock::cut_blocks_test {
namespace {

const std::vector<Segment> kSquare = rectangle_sides({0, 0}, {10, 10});

/// A slope with two joint sets, cut off by a polygonal outline; ends overshoot a little. Gaps stay above the
/// merging distance.
Drawing jointed_slope() {
  std::vector<Segment> lines = {{{-0.01, 0}, {10.01, 0}},
                                {{10, -0.01}, {10, 6.01}},
                                {{10.01, 6}, {4.99, 6}},
                                {{5.005, 6.01}, {0.995, -0.02}},
                                {{-0.02, 0.01}, {2, -0.01}}};
  for (int i = 0; i < 5; ++i) lines.push_back({{1.3 + 1.7 * i, -0.02}, {1.3 + 1.7 * i + 2.5, 6.02}});
  for (int i = 0; i < 4; ++i) lines.push_back({{0.5, 1.05 + 1.2 * i + 0.3}, {10.02, 0.35 + 1.2 * i}});
  return drawing_of(lines, 0.001);
}

Drawing permuted(Drawing drawing, unsigned seed) {
  std::shuffle(drawing.joints.begin(), drawing.joints.end(), std::mt19937(seed));
  return drawing;
}

template <class Map>
Drawing mapped(Drawing drawing, Map map) {
  for (JointLine& line : drawing.joints) line.segment = {map(line.segment.start), map(line.segment.end)};
  return drawing;
}

Drawing reversed(Drawing drawing) {
  for (JointLine& line : drawing.joints) std::swap(line.segment.start, line.segment.end);
  return drawing;
}

/// Mirrored blocks run clockwise: back to counter-clockwise.
template <class Map>
Blocks mapped_back(Blocks blocks, Map map, bool is_mirror) {
  const auto map_loop = [&](BlockLoop& loop) {
    for (BlockVertex& v : loop) v.position = map(v.position);
    if (is_mirror) std::reverse(loop.begin(), loop.end());
  };
  for (BlockPolygon& block : blocks.blocks) {
    map_loop(block.outer);
    for (BlockLoop& hole : block.holes) map_loop(hole);
  }
  return blocks;
}

void expect_same(const Blocks& a, const Blocks& b, double tolerance) {
  EXPECT_EQ(a.blocks.size(), b.blocks.size());
  EXPECT_EQ(count_missing(a, b, tolerance), 0);
  EXPECT_EQ(count_missing(b, a, tolerance), 0);
}

constexpr double kRoundOff = 1e-12;

}  // namespace

TEST(CutBlocks, a_square_with_a_cross_gives_four_blocks) {
  const Drawing drawing = drawing_of(kSquare + std::vector<Segment>{{{5, -1}, {5, 11}}, {{-1, 4}, {11, 4}}});
  const CutResult cut = cut_blocks(drawing);
  ASSERT_EQ(cut.blocks.blocks.size(), 4U);
  EXPECT_DOUBLE_EQ(total_area(cut.blocks), 100);
  EXPECT_TRUE(cut.snaps.empty());
  EXPECT_TRUE(has_warning(cut.warnings, "dangling_lines_removed")) << "the ends of the cross stand out by 1";
}

TEST(CutBlocks, areas_add_up_to_the_outline) {
  for (const double e0 : {0.0, 1e-6, 0.001}) {
    Drawing drawing = two_joint_sets(300, 0.5, 7);
    drawing.edge_node_ratio = e0;
    const Drawing outline = drawing_of(rectangle_sides({-1, -1}, {2, 2}));
    drawing.joints.insert(drawing.joints.begin(), outline.joints.begin(), outline.joints.end());
    const Blocks blocks = cut_blocks(drawing).blocks;
    EXPECT_GT(blocks.blocks.size(), 500U);
    EXPECT_NEAR(total_area(blocks), 9, 9e-12) << "e0 = " << e0;
  }
}

TEST(CutBlocks, order_of_lines_does_not_matter) {
  const Drawing drawing = jointed_slope();
  const Blocks blocks = cut_blocks(drawing).blocks;
  EXPECT_GT(blocks.blocks.size(), 20U);
  for (unsigned seed = 0; seed < 5; ++seed) expect_same(blocks, cut_blocks(permuted(drawing, seed)).blocks, kRoundOff);
}

TEST(CutBlocks, merging_of_whole_clusters_does_not_depend_on_the_order_of_lines) {
  Drawing drawing = random_lines(60, 0.6, 2);
  const Drawing outline = drawing_of(rectangle_sides({-0.7, -0.7}, {1.7, 1.7}));
  drawing.joints.insert(drawing.joints.begin(), outline.joints.begin(), outline.joints.end());
  drawing.edge_node_ratio = 0.01;
  const CutResult cut = cut_blocks(drawing);
  EXPECT_GT(cut.report.merged, 50);
  EXPECT_GT(cut.report.detours, 5);
  EXPECT_NEAR(total_area(cut.blocks), 2.4 * 2.4, 1e-12);
  for (unsigned seed = 0; seed < 5; ++seed)
    expect_same(cut.blocks, cut_blocks(permuted(drawing, seed)).blocks, kRoundOff);
  expect_same(cut.blocks, cut_blocks(reversed(drawing)).blocks, kRoundOff);
}

TEST(CutBlocks, direction_of_lines_does_not_matter) {
  expect_same(cut_blocks(jointed_slope()).blocks, cut_blocks(reversed(jointed_slope())).blocks, kRoundOff);
}

TEST(CutBlocks, a_mirror_image_has_mirrored_blocks) {
  const auto mirror = [](Point p) { return Point{-p.x, p.y}; };
  const Blocks mirrored = cut_blocks(mapped(jointed_slope(), mirror)).blocks;
  expect_same(cut_blocks(jointed_slope()).blocks, mapped_back(mirrored, mirror, true), kRoundOff);
}

TEST(CutBlocks, a_shift_by_ten_million_changes_nothing_but_last_digits) {
  const Point far{1e7, -1e7};
  const Blocks blocks = cut_blocks(mapped(jointed_slope(), [&](Point p) { return p + far; })).blocks;
  const Blocks back = mapped_back(
      blocks, [&](Point p) { return p - far; }, false);
  // The input itself moves by half a unit in the last place of 1e7, 1e-9; flat crossings more.
  expect_same(cut_blocks(jointed_slope()).blocks, back, 2e-8);
}

TEST(CutBlocks, exact_arrangement_of_a_lattice_survives_permutation_and_reversal) {
  const Drawing drawing = lattice_lines(400, 20, 5, 11);
  const Blocks blocks = cut_blocks(drawing).blocks;
  expect_same(blocks, cut_blocks(permuted(drawing, 3)).blocks, 1e-13);
  expect_same(blocks, cut_blocks(reversed(drawing)).blocks, 1e-13);
}

// The free end of a line that is drawn twice is no vertex.
Drawing each_line_once(Drawing drawing) {
  std::vector<JointLine> once;
  for (const JointLine& line : drawing.joints) {
    const Segment turned{line.segment.end, line.segment.start};
    const auto is_same = [&](const JointLine& other) {
      return other.segment == line.segment || other.segment == turned;
    };
    if (std::ranges::none_of(once, is_same)) once.push_back(line);
  }
  drawing.joints = std::move(once);
  return drawing;
}

TEST(CutBlocks, a_lattice_with_overlaps_has_the_vertices_and_edges_of_the_exact_arrangement) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Drawing drawing = lattice_lines(200, 12, 4, seed);
    const CutReport report = cut_blocks(drawing).report;
    const ExactCounts exact = count_exactly(each_line_once(drawing));
    EXPECT_EQ(report.nodes, exact.vertices) << seed;
    EXPECT_EQ(report.edges, exact.edges) << seed;
  }
}

TEST(CutBlocks, lines_through_a_corner_that_miss_it_by_rounding_meet_in_one_node) {
  const double off = 3e-10;
  const CutResult cut = cut_blocks(drawing_of(
      kSquare + std::vector<Segment>{{{-1, -1 + off}, {11, 11 + off}}, {{-1, 11 - off}, {11, -1 - off}}}, 0.01));
  EXPECT_EQ(cut.blocks.blocks.size(), 4U);
  EXPECT_TRUE(cut.snaps.empty()) << "moves within round-off do not count as snaps";
}

TEST(CutBlocks, nodes_nearer_than_the_merging_distance_become_one_and_are_reported) {
  // w0 = 1.02 * 5.05; merging below 0.064.
  const CutResult cut = cut_blocks(drawing_of(kSquare + std::vector<Segment>{{{0.05, -0.05}, {10.05, 10.05}}}, 0.01));
  EXPECT_EQ(cut.blocks.blocks.size(), 2U);
  EXPECT_TRUE(has_warning(cut.warnings, "nodes_merged"));
  EXPECT_FALSE(has_warning(cut.warnings, "nodes_merged_far"));
  EXPECT_FALSE(cut.snaps.empty());
  EXPECT_NEAR(total_area(cut.blocks), 100, 1e-10);
}

// The merging distance grows with the drawing: at the same ratio, bricks of a large wall become triangles.
TEST(CutBlocks, crossings_that_merging_moves_far_for_their_blocks_are_warned_of) {
  const auto wall = [](double ratio) {
    std::vector<Segment> lines{{{0, 0}, {20, 0}}, {{0, 10}, {20, 10}}, {{0, 0}, {0, 10}}, {{20, 0}, {20, 10}}};
    for (int row = 1; row < 20; ++row) lines.push_back({{0, row / 2.0}, {20, row / 2.0}});
    for (int column = 1; column < 40; ++column) lines.push_back({{column / 2.0, 0}, {column / 2.0, 10}});
    return cut_blocks(drawing_of(lines, ratio));
  };
  const CutResult far = wall(0.06);
  EXPECT_TRUE(has_warning(far.warnings, "nodes_merged"));
  EXPECT_TRUE(has_warning(far.warnings, "nodes_merged_far"));
  EXPECT_FALSE(has_warning(wall(0.01).warnings, "nodes_merged_far"));
}

TEST(CutBlocks, a_line_beside_another_nearer_than_the_tolerance_is_led_through_its_nodes) {
  // The second line bends 0.03 away from the side and back: no block that thin is left.
  const std::vector<Segment> lines = kSquare + std::vector<Segment>{{{3, 0}, {5, 0.03}}, {{5, 0.03}, {7, 0}}};
  const CutResult cut = cut_blocks(drawing_of(lines, 0.01));
  EXPECT_EQ(cut.blocks.blocks.size(), 1U);
  EXPECT_TRUE(has_warning(cut.warnings, "edges_rerouted"));
  Drawing kept = drawing_of(lines, 0.01);
  kept.boundary_count = 4;
  EXPECT_EQ(cut_blocks(kept).blocks.blocks.size(), 2U) << "boundary lines are never moved";
}

// The Berkeley program cuts it into two blocks (findings of legacy, defect C): it loses the piece that passes near a
// node.
TEST(CutBlocks, a_piece_that_passes_a_node_too_near_is_led_through_it_or_lost_as_in_the_old_program) {
  const Drawing drawing = drawing_of({{{-1.01, 0}, {34.55700538, 0}},
                                      {{19.995, 20.00866025}, {31.55200538, -0.008660254038}},
                                      {{7.294653722, 20.0025}, {26.3548382, 8.998097359}},
                                      {{21.97717505, -0.004531538935}, {26.25626918, 9.172015431}},
                                      {{19.61594631, -0.004531538935}, {24.95004037, 11.4344701}}},
                                     0.01);
  EXPECT_EQ(cut_blocks(drawing, NodeMerging::in_order_found).blocks.blocks.size(), 3U);
  const CutResult old = cut_blocks(drawing, NodeMerging::in_order_found, NearPieces::deleted);
  EXPECT_EQ(old.blocks.blocks.size(), 2U);
  EXPECT_GE(old.report.deleted, 1);
  EXPECT_TRUE(std::ranges::any_of(old.warnings, [](const Warning& w) { return w.name == "near_pieces_deleted"; }));
}

TEST(CutBlocks, an_end_that_falls_short_by_less_than_the_reach_meets_the_line) {
  const CutResult cut = cut_blocks(drawing_of(kSquare + std::vector<Segment>{{{5, 5e-7}, {5, 10}}}, 0.01));
  EXPECT_EQ(cut.blocks.blocks.size(), 2U);
  EXPECT_EQ(cut_blocks(drawing_of(kSquare + std::vector<Segment>{{{5, 1e-4}, {5, 10}}}, 0.01)).blocks.blocks.size(),
            1U);
}

TEST(CutBlocks, shared_edges_take_the_material_of_the_lower_numbered_line) {
  const std::vector<Segment> lines =
      rectangle_sides({0, 0}, {2, 1}) + std::vector<Segment>{{{1, 0}, {1, 1}}, {{1, -0.5}, {1, 1.5}}};
  const Blocks blocks = cut_blocks(drawing_of(lines)).blocks;
  ASSERT_EQ(blocks.blocks.size(), 2U);
  for (const BlockPolygon& block : blocks.blocks) {
    for (const BlockVertex& v : block.outer) EXPECT_NE(v.joint_material, 5);
  }
}

TEST(CutBlocks, a_joined_straight_edge_keeps_the_material_of_its_last_part) {
  // The lower side is two lines, 0 and 1, left to right: the edge arriving at (2, 0) is joined, its last part
  // is line 1.
  const std::vector<Segment> lines = {
      {{0, 0}, {1, 0}}, {{1, 0}, {2, 0}}, {{2, 0}, {2, 1}}, {{2, 1}, {0, 1}}, {{0, 1}, {0, 0}}};
  const Blocks blocks = cut_blocks(drawing_of(lines)).blocks;
  ASSERT_EQ(blocks.blocks.size(), 1U);
  const BlockLoop& loop = blocks.blocks[0].outer;
  ASSERT_EQ(loop.size(), 4U);
  const auto corner = std::find_if(loop.begin(), loop.end(), [](const BlockVertex& v) {
    return v.position == Point{2, 0};
  });
  ASSERT_NE(corner, loop.end());
  EXPECT_EQ(corner->joint_material, 1);
}

TEST(CutBlocks, a_loop_inside_a_block_is_cut_out_of_it) {
  const CutResult cut =
      cut_blocks(drawing_of(kSquare + rectangle_sides({2, 2}, {8, 8}) + rectangle_sides({4, 4}, {6, 6})));
  ASSERT_EQ(cut.blocks.blocks.size(), 3U);
  EXPECT_DOUBLE_EQ(total_area(cut.blocks), 100);
  EXPECT_DOUBLE_EQ(area(cut.blocks.blocks[0]), 64);
  EXPECT_DOUBLE_EQ(area(cut.blocks.blocks[1]), 32);
  EXPECT_DOUBLE_EQ(area(cut.blocks.blocks[2]), 4);
  EXPECT_LT(area(points_of(cut.blocks.blocks[0].holes.at(0))), 0) << "holes run clockwise";
  EXPECT_TRUE(has_warning(cut.warnings, "block_inside_block"));
}

TEST(CutBlocks, two_loops_side_by_side_inside_a_block_are_two_holes) {
  const CutResult cut =
      cut_blocks(drawing_of(kSquare + rectangle_sides({1, 1}, {3, 3}) + rectangle_sides({5, 2}, {8, 9})));
  ASSERT_EQ(cut.blocks.blocks.size(), 3U);
  EXPECT_EQ(cut.blocks.blocks[0].holes.size(), 2U);
  EXPECT_DOUBLE_EQ(total_area(cut.blocks), 100);
}

TEST(CutBlocks, a_loop_touching_its_surroundings_in_a_vertex_is_cut_out) {
  for (const double e0 : {0.0, 0.001}) {
    const std::vector<Segment> triangle = {{{0, 0}, {6, 2}}, {{6, 2}, {2, 6}}, {{2, 6}, {0, 0}}};
    const CutResult cut = cut_blocks(drawing_of(kSquare + triangle, e0));
    ASSERT_EQ(cut.blocks.blocks.size(), 2U);
    EXPECT_NEAR(total_area(cut.blocks), 100, 1e-12);
    const auto with_hole = std::count_if(cut.blocks.blocks.begin(), cut.blocks.blocks.end(),
                                         [](const BlockPolygon& b) { return b.holes.size() == 1; });
    EXPECT_EQ(with_hole, 1);
  }
}

TEST(CutBlocks, loops_touching_each_other_inside_a_block_are_holes_of_it) {
  const CutResult cut =
      cut_blocks(drawing_of(kSquare + rectangle_sides({2, 2}, {4, 4}) + rectangle_sides({4, 4}, {7, 7})));
  ASSERT_EQ(cut.blocks.blocks.size(), 3U);
  EXPECT_EQ(cut.blocks.blocks[0].holes.size(), 2U);
  EXPECT_NEAR(total_area(cut.blocks), 100, 1e-12);
}

TEST(CutBlocks, a_bridge_between_a_hole_and_the_outside_is_removed) {
  const CutResult cut =
      cut_blocks(drawing_of(kSquare + rectangle_sides({4, 4}, {6, 6}) + std::vector<Segment>{{{0, 5}, {4, 5}}}));
  ASSERT_EQ(cut.blocks.blocks.size(), 2U);
  EXPECT_EQ(cut.report.bridge_edges, 1);
  EXPECT_TRUE(has_warning(cut.warnings, "bridge_lines_removed"));
  EXPECT_DOUBLE_EQ(total_area(cut.blocks), 100);
}

TEST(CutBlocks, dangling_pieces_are_removed_until_none_is_left) {
  const std::vector<Segment> tree = {{{5, 0}, {5, 5}}, {{3, 3}, {7, 3}}, {{4, 2}, {4, 4}}};
  const CutResult cut = cut_blocks(drawing_of(kSquare + tree));
  EXPECT_EQ(cut.blocks.blocks.size(), 1U);
  const auto warning = std::find_if(cut.warnings.begin(), cut.warnings.end(),
                                    [](const Warning& w) { return w.name == "dangling_lines_removed"; });
  ASSERT_NE(warning, cut.warnings.end());
  EXPECT_EQ(warning->place.line, 5) << "the first line of the tree";
}

TEST(CutBlocks, an_open_polygon_is_refused_with_the_place_of_the_drawing) {
  try {
    cut_blocks(drawing_of({{{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}, {{1, 1}, {0, 1}}}));
    FAIL() << "should have been refused";
  } catch (const InputError& error) {
    EXPECT_EQ(error.place().file, "drawing");
    EXPECT_NE(std::string(error.what()).find("at least one block"), std::string::npos);
  }
  EXPECT_THROW(cut_blocks(Drawing{}), InputError);
}

TEST(CutBlocks, repeated_and_overlapping_lines_are_reported_and_harmless) {
  const std::vector<Segment> extra = {{{10, 0}, {0, 0}}, {{3, 10}, {12, 10}}};
  for (const double e0 : {0.0, 0.01}) {
    const CutResult cut = cut_blocks(drawing_of(kSquare + extra, e0));
    EXPECT_EQ(cut.blocks.blocks.size(), 1U);
    EXPECT_EQ(cut.blocks.blocks[0].outer.size(), 4U);
    EXPECT_TRUE(has_warning(cut.warnings, "duplicate_line"));
    EXPECT_TRUE(has_warning(cut.warnings, "overlapping_lines"));
  }
}

// A drawing exported many times over itself: not each pair of lines may count as a crossing, which took 3.9 GB.
TEST(CutBlocks, lines_repeated_thousands_of_times_cut_as_if_drawn_once) {
  std::vector<Segment> many;
  for (int i = 0; i < 2500; ++i)
    for (const Segment& s : kSquare) many.push_back(i % 2 == 0 ? s : Segment{s.end, s.start});
  for (const double e0 : {0.0, 0.01}) {
    const CutResult once = cut_blocks(drawing_of(kSquare, e0));
    const CutResult cut = cut_blocks(drawing_of(many, e0));
    EXPECT_EQ(cut.blocks.blocks, once.blocks.blocks);
    EXPECT_EQ(cut.report.crossings, once.report.crossings);
    ASSERT_EQ(cut.warnings.size(), 1U);
    EXPECT_EQ(cut.warnings[0].name, "duplicate_line");
    EXPECT_NE(cut.warnings[0].sentence.find("(9996 in all)"), std::string::npos) << cut.warnings[0].sentence;
  }
}

// Two of the lines leave the leftmost point of the inner part at an angle of one rounding. Rounded coordinates do not
// decide which of them is the outermost.
TEST(CutBlocks, lines_a_rounding_apart_leave_every_block_its_area) {
  const std::vector<Segment> lines = {
      {{0.24056261216234409, 0.58333333333333326}, {0.38490017945975052, 0.66666666666666663}},
      {{0.24056261216234409, 0.58333333333333326}, {0.81791288135196982, 0.91666666666666663}},
      {{0.24056261216234409, 0.58333333333333326}, {0.52923774675715696, 0.58333333333333326}},
      {{0.40833924066960220, 0.58333333333333326}, {0.40833924066960220, 0.70}},
      {{0.32202003029785337, 0.58333333333333326}, {0.32202003029785337, 0.70}}};
  const CutResult cut = cut_blocks(drawing_of(rectangle_sides({0, 0}, {1, 1}) + lines, 0));
  EXPECT_NEAR(total_area(cut.blocks), 1, 1e-12);
  for (const BlockPolygon& block : cut.blocks.blocks) EXPECT_GT(area(block), -1e-15);
}

}  // namespace keyblock::cut_blocks_test
