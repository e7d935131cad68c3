// The block file: points of 3 and 4 numbers, scratch slots, and the edge a joint material belongs to.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/shi/dda_blocks.hpp"

#include <gtest/gtest.h>

#include "formats/registry.hpp"
#include "tests/formats/reading.hpp"

namespace keyblock::formats::dda_blocks_test {
namespace {

/// Two unit squares side by side; the edge between them has joint material 2 (index from 0), the top of the
/// first 1, the others 0.
Blocks two_squares() {
  Blocks blocks;
  blocks.blocks = {{0, {{{0, 0}, 0}, {{1, 0}, 0}, {{1, 1}, 2}, {{0, 1}, 1}}, {}},
                   {1, {{{1, 0}, 2}, {{2, 0}, 0}, {{2, 1}, 0}, {{1, 1}, 0}}, {}}};
  blocks.bolts = {{{{.5, .5}, {1.5, .5}}, 0, 1, 1e6, 2e3, 50}};
  blocks.fixed_points = {{{.5, .1}, 0, {}}};
  blocks.loading_points = {{{1.5, .9}, 1, {}}};
  blocks.measured_points = {{{1.5, .5}, 1, {}}, {{.5, .5}, 0, {}}};
  return blocks;
}

const std::string kRanges = "2 0 16\n1 1 1\n1 1 4\n2 9 12\n";

/// The same two squares with the materials of edges that leave; scratch slots hold what no reader may trust.
const std::string kLeavingSlots =
    "1 0 0\n3 1 0\n2 1 1\n1 0 1\n1 0 0\n9 9 9\n9 9 9\n9 9 9\n"
    "1 1 0\n1 2 0\n1 2 1\n3 1 1\n1 1 0\n9 9 9\n9 9 9\n9 9 9\n";

}  // namespace

TEST(DdaBlocks, everything_but_places_survives_writing_and_reading) {
  const std::string text = kDdaBlocks.write({{}, two_squares(), {}});
  const Reading reading = read({"f", text});
  EXPECT_EQ(reading.warnings, Warnings{});
  EXPECT_EQ(reading.content.blocks->blocks, two_squares().blocks);
  EXPECT_EQ(kDdaBlocks.write(reading.content), text);
}

TEST(DdaBlocks, written_file_has_the_slots_of_the_specification) {
  Blocks blocks;
  blocks.blocks = {{0, {{{0, 0}, 0}, {{2, 0}, 1}, {{2, 2}, 2}, {{0, 2}, 3}}, {}}};
  EXPECT_EQ(kDdaBlocks.write({{}, blocks, {}}),
            "1 0 8\n0 0 0\n1 1 4\n1 0 0\n2 2 0\n3 2 2\n4 0 2\n"
            "1 0 0\n"                   // the first vertex again
            "0 1.4142135623730951 4\n"  // largest radius, area
            "0 4 4\n"                   // first moments of area
            "0 1 1\n");                 // centroid
}

TEST(DdaBlocks, points_of_three_numbers_are_recognised_by_the_total) {
  const Reading reading = read({"f", kRanges + kLeavingSlots + ".5 .1 1\n1.5 .9 2\n1.5 .5 2\n"});
  EXPECT_EQ(reading.content.blocks->loading_points.at(0).position, (Point{1.5, .9}));
  EXPECT_EQ(reading.content.blocks->loading_points.at(0).block, 1);
}

TEST(DdaBlocks, points_of_three_numbers_are_written_on_request) {
  const std::string three = kDdaBlocksOfThree.write({{}, two_squares(), {}});
  EXPECT_TRUE(three.ends_with("\n0.5 0.1 1\n1.5 0.9 2\n1.5 0.5 2\n0.5 0.5 1\n"));
  EXPECT_EQ(kDdaBlocks.write(read({"f", three}).content), kDdaBlocks.write({{}, two_squares(), {}}));
}

TEST(DdaBlocks, materials_of_leaving_edges_are_found_out_and_moved) {
  const Reading reading = read({"f", kRanges + kLeavingSlots + "0 .5 .1 1\n2 1.5 .9 2\n1 1.5 .5 2\n"});
  EXPECT_EQ(names(reading.warnings), std::vector<std::string>{"leaving_edge_materials"});
  EXPECT_EQ(reading.content.blocks->blocks, two_squares().blocks);
}

// The slot behind a block's corners repeats the first, those behind hold measures: only corners have materials.
TEST(DdaBlocks, a_fraction_as_the_material_of_a_corner_is_a_warning) {
  std::string text = kDdaBlocks.write({{}, two_squares(), {}});
  const std::size_t corner = text.find("\n1 1 0\n");
  ASSERT_NE(corner, std::string::npos) << text;
  const Reading reading = read({"f", text.replace(corner, 7, "\n1.5 1 0\n")});
  ASSERT_EQ(names(reading.warnings), std::vector<std::string>{"joint_material_not_whole"}) << text;
  EXPECT_EQ(reading.warnings[0].place.line, 6);
  EXPECT_EQ(reading.content.blocks->blocks.at(0).outer.at(1).joint_material, -1);
}

TEST(DdaBlocks, fixed_point_in_block_0_is_left_out_and_loading_point_refused) {
  const Reading reading = read({"f", kRanges + kLeavingSlots + ".5 .1 0\n1.5 .9 2\n1.5 .5 2\n"});
  EXPECT_EQ(names(reading.warnings), (std::vector<std::string>{"point_outside_blocks", "leaving_edge_materials"}));
  EXPECT_TRUE(reading.content.blocks->fixed_points.empty());
  EXPECT_NE(error_of(kRanges + kLeavingSlots + ".5 .1 1\n1.5 .9 0\n1.5 .5 2\n"), "");
}

TEST(DdaBlocks, slots_that_overlap_or_leave_the_file_are_errors) {
  EXPECT_NE(error_of("2 0 16\n1 1 1\n1 1 4\n2 8 12\n" + kLeavingSlots), "");
  EXPECT_NE(error_of("2 0 16\n1 1 1\n1 1 4\n2 9 2000000000\n" + kLeavingSlots), "");
  EXPECT_NE(error_of("2 0 2000000000\n1 1 1\n1 1 4\n2 9 12\n" + kLeavingSlots), "");
}

TEST(DdaBlocks, holes_are_not_written) {
  Blocks blocks = two_squares();
  blocks.blocks[0].holes = {{{{.2, .2}, 0}, {{.2, .4}, 0}, {{.4, .2}, 0}}};
  EXPECT_EQ(kDdaBlocks.write({{}, blocks, {}}), kDdaBlocks.write({{}, two_squares(), {}}));
}

TEST(DdaBlocks, writing_without_blocks_is_a_fault_of_the_caller) {
  EXPECT_THROW(kDdaBlocks.write({}), std::invalid_argument);
}

}  // namespace keyblock::formats::dda_blocks_test
