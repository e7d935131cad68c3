// Meetings of segments are decided exactly, distances are right beyond the ends.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/segment.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace keyblock::segment_test {

TEST(Segment, distance_counts_from_the_nearest_end_beyond_the_ends) {
  const Segment s{{0, 0}, {4, 0}};
  EXPECT_DOUBLE_EQ(distance(s, {2, 3}), 3);
  EXPECT_DOUBLE_EQ(distance(s, {7, 4}), 5);
  EXPECT_DOUBLE_EQ(distance_to_carrier(s, {7, 4}), 4);
  EXPECT_DOUBLE_EQ(foot(s, {7, 4}), 1.75);
}

TEST(Segment, a_segment_without_length_is_a_point) {
  const Segment s{{1, 1}, {1, 1}};
  EXPECT_DOUBLE_EQ(distance(s, {4, 5}), 5);
  EXPECT_DOUBLE_EQ(distance_to_carrier(s, {4, 5}), 5);
}

TEST(Segment, meetings_are_told_apart) {
  const Segment s{{0, 0}, {4, 4}};
  EXPECT_EQ(meeting(s, {{0, 4}, {4, 0}}), Meeting::crossing);
  EXPECT_EQ(meeting(s, {{2, 2}, {9, 0}}), Meeting::crossing) << "an end on the segment";
  EXPECT_EQ(meeting(s, {{4, 4}, {9, 0}}), Meeting::crossing) << "end to end";
  EXPECT_EQ(meeting(s, {{3, 3}, {9, 9}}), Meeting::overlapping);
  EXPECT_EQ(meeting(s, {{4, 4}, {9, 9}}), Meeting::overlapping) << "in one point, along each other";
  EXPECT_EQ(meeting(s, {{5, 5}, {9, 9}}), Meeting::none);
  EXPECT_EQ(meeting(s, {{0, 1}, {4, 5}}), Meeting::none);
  EXPECT_EQ(meeting(s, {{3, 0}, {3, 2}}), Meeting::none);
}

TEST(Segment, parts_along_others_are_cut_at_their_ends_and_joined) {
  const Segment s{{0, 0}, {4, 0}};
  const auto parts = [&](const std::vector<Segment>& others) { return parts_along(s, others, 1e-9); };
  const std::vector<Segment> two{{{0.5, 0}, {1.5, 0}}, {{3, 0}, {9, 0}}};
  EXPECT_EQ(parts({{{-1, 0}, {7, 0}}}), std::vector<Segment>{s}) << "all of it, to the bit";
  EXPECT_EQ(parts({two[1], two[0]}), (std::vector<Segment>{two[0], {{3, 0}, {4, 0}}}));
  EXPECT_EQ(parts({{{1, 0}, {2, 0}}, {{3, 0}, {2, 0}}, {{1.5, 0}, {1.7, 0}}}), (std::vector<Segment>{{{1, 0}, {3, 0}}}))
      << "end to end, over one another, either way";
  EXPECT_TRUE(parts({{{1, 0}, {2, 1e-3}}}).empty()) << "leaves it";
  EXPECT_TRUE(parts({{{1, -1}, {1, 1}}, {{4, 0}, {4, 3}}, {{4, 0}, {6, 0}}}).empty()) << "meets it in a point";
  EXPECT_EQ(parts({{{1, 5e-10}, {2, -5e-10}}}).size(), 1U) << "near";
}

}  // namespace keyblock::segment_test
