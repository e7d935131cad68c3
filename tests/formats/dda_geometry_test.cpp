// The native geometry file: its contents, its variants, and the places of faults.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/shi/dda_geometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "formats/registry.hpp"
#include "tests/formats/reading.hpp"
#include "tests/support/content_text.hpp"

namespace keyblock::formats::dda_geometry_test {
namespace {

const std::string kLines = "0 0 1 0 1\n1 0 1 1 2\n1 1 0 0 3\n";
const std::string kFull =
    "0.01\n3 2\n1\n1\n1\n1\n1\n1\n" + kLines + "0 .5 1 .5 2\n.1 .1 .9 .1 1e6 2e3 50\n.5 -1 .5 2\n.6 .2\n.7 .2\n.8 .2\n";

Drawing drawing_of(const std::string& text) {
  return *read({"f", text}).content.drawing;
}

}  // namespace

TEST(DdaGeometry, every_record_lands_in_its_place) {
  const Drawing drawing = drawing_of(kFull);
  EXPECT_EQ(drawing.edge_node_ratio, 0.01);
  EXPECT_EQ(drawing.boundary_count, 2u);
  ASSERT_EQ(drawing.joints.size(), 3u);
  EXPECT_EQ(drawing.joints[1].segment, (Segment{{1, 0}, {1, 1}}));
  EXPECT_EQ(drawing.joints[2].joint_material, 2);
  EXPECT_EQ(drawing.joints[2].place, (Place{"f", 11, 1}));
  ASSERT_EQ(drawing.material_lines.size(), 1u);
  EXPECT_EQ(drawing.material_lines[0].block_material, 1);
  ASSERT_EQ(drawing.bolts.size(), 1u);
  EXPECT_EQ(drawing.bolts[0].pretension, 50);
  ASSERT_EQ(drawing.fixed_lines.size(), 1u);
  EXPECT_EQ(drawing.fixed_lines[0].segment, (Segment{{.5, -1}, {.5, 2}}));
  EXPECT_EQ(drawing.loading_points.at(0).position, (Point{.6, .2}));
  EXPECT_EQ(drawing.measured_points.at(0).position, (Point{.7, .2}));
  EXPECT_EQ(drawing.hole_points.at(0).position, (Point{.8, .2}));
}

TEST(DdaGeometry, written_text_is_read_back_to_the_same_text) {
  const std::string text = kDdaGeometry.write(read({"f", kFull}).content);
  EXPECT_EQ(kDdaGeometry.write(read({"f", text}).content), text);
  EXPECT_EQ(read({"f", text}).warnings, Warnings{});
}

TEST(DdaGeometry, line_ends_tabs_and_missing_final_newline_change_nothing) {
  const std::string expected = kDdaGeometry.write(read({"f", kFull}).content);
  std::string crlf, one_line = kFull, tabs = kFull;
  for (const char c : kFull) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  std::ranges::replace(one_line, '\n', ' ');
  std::ranges::replace(tabs, ' ', '\t');
  for (const std::string& text : {crlf, one_line, tabs, kFull.substr(0, kFull.size() - 1), "\xEF\xBB\xBF" + kFull}) {
    const Reading reading = read({"f", text});
    EXPECT_EQ(kDdaGeometry.write(reading.content), expected);
    EXPECT_EQ(reading.warnings, Warnings{});
  }
}

TEST(DdaGeometry, fixed_points_of_two_numbers_are_a_named_variant) {
  const Reading reading = read({"f", "0.01 3 0 0 0 2 0 0 0\n" + kLines + ".5 .1\n.6 .2\n"});
  EXPECT_EQ(names(reading.warnings), std::vector<std::string>{"fixed_points_of_two_numbers"});
  ASSERT_EQ(reading.content.drawing->fixed_lines.size(), 2u);
  EXPECT_EQ(reading.content.drawing->fixed_lines[1].segment, (Segment{{.6, .2}, {.6, .2}}));
}

TEST(DdaGeometry, bolts_of_none_four_seven_and_nine_numbers_are_read) {
  const std::string head = "0.01 3 0 0 2 1 0 0 0\n" + kLines;
  const std::string fixed = ".5 .1 .5 .1\n";
  const auto bolts = [&](const std::string& bolt) { return read({"f", head + bolt + bolt + fixed}); };
  EXPECT_EQ(names(bolts("").warnings), std::vector<std::string>{"bolts_without_data"});
  EXPECT_EQ(names(bolts(".1 .1 .9 .1\n").warnings), std::vector<std::string>{"bolts_without_properties"});
  EXPECT_EQ(names(bolts(".1 .1 .9 .1 1e6 0 5\n").warnings), std::vector<std::string>{});
  const Reading nine = bolts(".1 .1 .9 .1 1 2 1e6 0 5\n");
  EXPECT_EQ(names(nine.warnings), std::vector<std::string>{"bolts_with_block_numbers"});
  EXPECT_EQ(nine.content.drawing->bolts.at(1).pretension, 5);
  EXPECT_EQ(nine.content.drawing->fixed_lines.at(0).segment.start, (Point{.5, .1}));
}

TEST(DdaGeometry, bolts_of_every_variant_are_written_with_seven_numbers_and_read_back) {
  const std::string head = "0.01 3 0 0 2 1 0 0 0\n" + kLines;
  for (const std::string bolt : {"", ".1 .1 .9 .1\n", ".1 .1 .9 .1 1e6 0 5\n", ".1 .1 .9 .1 1 2 1e6 0 5\n"}) {
    const Content content = read({"f", head + bolt + bolt + ".5 .1 .5 .1\n"}).content;
    const Reading again = read({"f", kDdaGeometry.write(content)});
    EXPECT_EQ(again.warnings, Warnings{}) << bolt;
    EXPECT_EQ(keyblock::support::content_text(again.content), keyblock::support::content_text(content)) << bolt;
  }
}

TEST(DdaGeometry, head_without_hole_count_is_a_named_variant) {
  const Reading reading = read({"f", "0.01 3 0 0 0 1 0 1\n" + kLines + ".5 .1 .5 .1\n.25 .75\n"});
  EXPECT_EQ(names(reading.warnings), std::vector<std::string>{"hole_count_missing"});
  EXPECT_EQ(reading.content.drawing->measured_points.at(0).position, (Point{.25, .75}));
}

TEST(DdaGeometry, points_missing_at_the_end_are_a_named_variant) {
  const Reading reading = read({"f", "0.01 3 0 0 0 1 1 2 0\n" + kLines + ".5 .1 .5 .1\n.25 .75\n.3 .7\n"});
  EXPECT_EQ(names(reading.warnings), std::vector<std::string>{"points_missing"});
  EXPECT_EQ(reading.content.drawing->loading_points.size(), 1u);
  EXPECT_EQ(reading.content.drawing->measured_points.size(), 1u);
}

TEST(DdaGeometry, surplus_numbers_and_trailing_text_are_warnings_with_their_place) {
  const Reading reading = read({"f", "0.01 3 0 0 0 0 0 0 0\n" + kLines + "7 8\nthe end"});
  ASSERT_EQ(names(reading.warnings), (std::vector<std::string>{"surplus_numbers", "trailing_text"}));
  EXPECT_EQ(reading.warnings[0].place, (Place{"f", 5, 1}));
  EXPECT_EQ(reading.warnings[1].place, (Place{"f", 6, 1}));
}

TEST(DdaGeometry, file_that_breaks_off_is_an_error_where_it_ends) {
  EXPECT_EQ(error_of("0.01 3 0 0 0 0 0 0 0\n0 0 1 0 1\n1 0"),
            "f:3:4: error: expected x of the end of line 2 of 3, found end of file");
}

TEST(DdaGeometry, more_boundary_lines_than_lines_are_an_error) {
  EXPECT_EQ(error_of("0.01 3 4 0 0 0 0 0 0\n" + kLines + "1"),
            "f:1:8: error: expected the number of boundary lines (at most 3, the number of lines), found \"4\"");
}

TEST(DdaGeometry, counts_of_a_thousand_million_are_refused_at_the_count) {
  EXPECT_EQ(error_of("0.01 3 0 0 1000000000 0 0 0 0\n" + kLines),
            "f:1:12: error: expected the number of bolts (at most 19: so many values follow), found "
            "\"1000000000\"");
}

}  // namespace keyblock::formats::dda_geometry_test
