// Ends that stop just short of a line, or pass it a little: found with their width, joined, trimmed.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/lines/near_ends.hpp"

#include <gtest/gtest.h>

namespace keyblock::near_ends_test {
namespace {

Drawing lines_drawn(const std::vector<Segment>& lines) {
  Drawing drawing;
  drawing.edge_node_ratio = 0.001;
  for (const Segment& line : lines) drawing.joints.push_back({line, 0, {}});
  drawing.boundary_count = lines.size();
  return drawing;
}

void expect_near(const Segment& found, const Segment& wanted) {
  EXPECT_LT(distance(found.start, wanted.start), 1e-12);
  EXPECT_LT(distance(found.end, wanted.end), 1e-12);
}

}  // namespace

TEST(NearEnds, an_end_beside_a_line_is_found_and_one_on_it_is_not) {
  const std::vector<Segment> lines{{{0, 0}, {10, 0}}, {{3, 0.02}, {3, 5}}, {{6, 0}, {6, 5}}};
  NearEndSearch search(lines, 0, 0.05);
  const auto near = search.look(1, true, 0);
  ASSERT_TRUE(near);
  EXPECT_EQ(near->other, 0U);
  EXPECT_NEAR(near->gap(), 0.02, 1e-15);
  EXPECT_FALSE(search.look(1, false, 0)) << "far from all";
  EXPECT_FALSE(search.look(2, true, 0)) << "on the line";
}

TEST(NearEnds, an_end_that_passes_a_line_is_beyond_it_unless_so_much_is_allowed) {
  const std::vector<Segment> lines{{{0, 0}, {10, 0}}, {{3, -0.02}, {3, 5}}};
  NearEndSearch search(lines, 0, 0.05);
  const auto near = search.look(1, true, 0);
  ASSERT_TRUE(near);
  EXPECT_TRUE(near->is_beyond);
  EXPECT_FALSE(search.look(1, true, 0.03));
}

TEST(NearEnds, a_line_drawn_twice_does_not_hide_the_gap_of_both) {
  const std::vector<Segment> lines{{{0, 0}, {10, 0}}, {{3, 0.02}, {3, 5}}, {{3, 0.02}, {3, 5}}};
  NearEndSearch search(lines, 0, 0.05);
  EXPECT_TRUE(search.look(1, true, 0));
  EXPECT_TRUE(search.look(2, true, 0));
}

TEST(NearEnds, a_joint_goes_on_along_its_own_line) {
  Drawing drawing = lines_drawn({{{0, 0}, {10, 0}}, {{2.01, 0.01}, {4, 2}}});
  const Warnings told = join_ends(drawing, 0.02);
  expect_near(drawing.joints[1].segment, {{2, 0}, {4, 2}});
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].name, "ends_joined");
  EXPECT_EQ(told[0].sentence,
            "1 end of a line is joined to a near line; the farthest moved by 0.0141, at (2.01, 0.01)");
}

TEST(NearEnds, a_corner_is_where_both_lines_lead) {
  Drawing drawing = lines_drawn({{{0, 0}, {9.99, 0}}, {{10, 0.01}, {10, 5}}});
  join_ends(drawing, 0.02);
  expect_near(drawing.joints[0].segment, {{0, 0}, {10, 0}});
  expect_near(drawing.joints[1].segment, {{10, 0}, {10, 5}});
  EXPECT_EQ(drawing.joints[0].segment.end, drawing.joints[1].segment.start) << "one point to the last digit";
}

// A joint that crosses the outline beside an open corner does not close the outline.
TEST(NearEnds, an_outline_is_closed_with_itself_before_any_joint) {
  Drawing drawing = lines_drawn({{{0, 0}, {9.98, 0}}, {{10, 0.02}, {10, 5}}});
  drawing.joints.push_back({{{9.985, -3}, {9.965, 3}}, 0, {}});
  drawing.boundary_count = 2;
  join_ends(drawing, 0.05);
  EXPECT_EQ(drawing.joints[0].segment.end, drawing.joints[1].segment.start);
  EXPECT_LT(distance(drawing.joints[0].segment.end, {10, 0}), 1e-12);
}

TEST(NearEnds, ends_along_one_line_meet) {
  Drawing drawing = lines_drawn({{{0, 0}, {4.99, 0}}, {{5, 0}, {10, 0}}});
  join_ends(drawing, 0.02);
  EXPECT_EQ(drawing.joints[0].segment.end, drawing.joints[1].segment.start);
}

TEST(NearEnds, what_is_farther_than_the_distance_stays_to_the_last_digit) {
  const std::vector<Segment> lines{{{0, 0}, {10, 0}}, {{3, 0.03}, {3, 5}}, {{6, -0.03}, {6, 5}}};
  Drawing drawing = lines_drawn(lines);
  EXPECT_TRUE(join_ends(drawing, 0.02).empty());
  for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_EQ(drawing.joints[i].segment, lines[i]);
}

TEST(NearEnds, a_line_shorter_than_the_distance_does_not_vanish) {
  Drawing drawing = lines_drawn({{{0, 0}, {10, 0}}, {{3, 0.005}, {3, 0.015}}});
  join_ends(drawing, 0.05);
  EXPECT_NE(drawing.joints[1].segment.start, drawing.joints[1].segment.end);
}

}  // namespace keyblock::near_ends_test
