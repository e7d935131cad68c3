// One kind of geometry made of another: parts without a place in it are refused or named.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/convert/derived_geometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "formats/dxf/dxf.hpp"
#include "geometry/polygon.hpp"
#include "tests/support/two_triangles.hpp"

namespace keyblock::study::derived_geometry_test {
namespace {

using formats::Content;

Content cover_of(Cover cover) {
  Content content;
  content.cover = std::move(cover);
  return content;
}

}  // namespace

// Four blocks round a gap (a tunnel), the first with a hole that a smaller block partly fills.
TEST(DerivedGeometry, gaps_within_blocks_stay_empty_as_lines) {
  const auto box = [](double x, double y, double width, double height) {
    return BlockPolygon{0, {{{x, y}, 0}, {{x + width, y}, 0}, {{x + width, y + height}, 0}, {{x, y + height}, 0}}, {}};
  };
  Blocks blocks;
  blocks.blocks = {box(0, 0, 9, 3), box(0, 3, 3, 3), box(6, 3, 3, 3), box(0, 6, 9, 3), box(1, 1, 0.5, 1)};
  blocks.blocks[0].holes = {{{{1, 1}, 0}, {{1, 2}, 0}, {{2, 2}, 0}, {{2, 1}, 0}}};
  Content content;
  content.blocks = blocks;
  const Derivation lines = as_lines(content).value();
  EXPECT_EQ(lines.content.drawing->hole_points.size(), 2U) << "half the hole, and the gap";
  const Derivation again = as_blocks(lines.content).value();
  std::vector<double> areas, cut_areas;
  for (const BlockPolygon& block : blocks.blocks) areas.push_back(area(points_of(block.outer)));
  for (const BlockPolygon& block : again.content.blocks->blocks) cut_areas.push_back(area(points_of(block.outer)));
  std::ranges::sort(areas);
  std::ranges::sort(cut_areas);
  EXPECT_EQ(cut_areas, areas);
}

// The lines themselves hold the least distance of nodes: through a DXF file too.
TEST(DerivedGeometry, blocks_thinner_than_the_edge_node_ratio_of_a_drawing_stay_apart_when_cut_again) {
  const auto box = [](double left, double right) {
    return BlockPolygon{0, {{{left, 0}, 0}, {{right, 0}, 0}, {{right, 2}, 0}, {{left, 2}, 0}}, {}};
  };
  Content content;
  content.blocks.emplace().blocks = {box(0, 2), box(2, 2.0005), box(2.0005, 4)};
  const std::string text = formats::kDxf.write(as_lines(content).value().content);
  const formats::Reading again = formats::kDxf.read({"f", text}, {});
  EXPECT_EQ(as_blocks(again.content).value().content.blocks->blocks.size(), 3U);
}

TEST(DerivedGeometry, what_cutting_leaves_out_is_said) {
  Content content;
  content.drawing.emplace().edge_node_ratio = 0.001;
  for (const Segment& line : {Segment{{0, 0}, {2, 0}}, Segment{{2, 0}, {1, 2}}, Segment{{1, 2}, {0, 0}}})
    content.drawing->joints.push_back({line, 0, {}});
  content.drawing->measured_points = {{{5, 5}, {"a.geo", 9, 1}}};
  const Derivation cut = as_blocks(content).value();
  ASSERT_EQ(cut.warnings.size(), 1U);
  EXPECT_EQ(cut.warnings[0].name, "point_outside_blocks");
}

TEST(DerivedGeometry, the_loops_of_a_cover_are_its_blocks) {
  const Derivation derived = as_blocks(cover_of(support::two_triangles())).value();
  EXPECT_EQ(derived.from, "cover");
  EXPECT_EQ(derived.warnings, Warnings{});
  const Blocks& blocks = *derived.content.blocks;
  // The joint material of a loop's corner is that of the edge that leaves it, of a block's that of the edge that
  // arrives.
  ASSERT_EQ(blocks.blocks.size(), 2U);
  EXPECT_EQ(blocks.blocks[0], (BlockPolygon{0, {{{0, 0}, 1}, {{1, 0}, 0}, {{1, 1}, 0}}, {}}));
  EXPECT_EQ(blocks.fixed_points.at(0).block, 0);
  EXPECT_EQ(blocks.loading_points.at(0).block, 1);
  EXPECT_EQ(blocks.measured_points.at(1).block, 1);
}

// Left out, it would hand its load to the next point.
TEST(DerivedGeometry, a_loading_point_outside_the_loops_is_refused) {
  Cover cover = support::two_triangles();
  cover.loading_points.insert(cover.loading_points.begin(), {{5, 5}, 0, {"a.cv", 3, 1}});
  try {
    as_blocks(cover_of(cover));
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "a.cv:3:1: error: expected a loading point inside a block, found (5, 5) outside all loops of the cover");
  }
}

TEST(DerivedGeometry, other_points_outside_the_loops_are_left_out_with_a_warning) {
  Cover cover = support::two_triangles();
  cover.fixed_points.insert(cover.fixed_points.begin(), {{5, 5}, 0, {}});
  const Derivation derived = as_blocks(cover_of(cover)).value();
  EXPECT_EQ(derived.content.blocks->fixed_points.size(), 1U);
  ASSERT_EQ(derived.warnings.size(), 1U);
  EXPECT_EQ(derived.warnings[0].name, "point_outside_blocks");
}

}  // namespace keyblock::study::derived_geometry_test
