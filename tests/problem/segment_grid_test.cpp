// The grid misses no pair that comes near, and answers in order.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/lines/segment_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry/segment.hpp"

namespace keyblock::segment_grid_test {
namespace {

std::vector<Segment> random_segments(int count, double longest, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-5, 25);
  std::uniform_real_distribution<double> reach(-longest, longest);
  std::vector<Segment> segments;
  for (int i = 0; i < count; ++i) {
    const Point start{place(random), place(random)};
    segments.push_back({start, start + Point{reach(random), i % 5 == 0 ? 0 : reach(random)}});
  }
  segments.push_back({{3, -5}, {3, 25}});       // vertical
  segments.push_back({{4, 4}, {4, 4}});         // a point
  segments.push_back({{-5, -5}, {25, 25.01}});  // across everything
  return segments;
}

double gap(const Segment& a, const Segment& b) {
  if (a.start != a.end && b.start != b.end && meeting(a, b) != Meeting::none) return 0;
  return std::min({distance(a, b.start), distance(a, b.end), distance(b, a.start), distance(b, a.end)});
}

}  // namespace

TEST(SegmentGrid, every_segment_nearer_than_the_margin_is_found) {
  for (double longest : {0.1, 2.0, 30.0}) {
    for (double margin : {0.0, 0.05}) {
      const std::vector<Segment> segments = random_segments(400, longest, 11);
      SegmentGrid grid(segments, margin);
      int near_pairs = 0;
      for (int i = 0; i < static_cast<int>(segments.size()); ++i) {
        const std::vector<int> found = grid.near(segments[i], i);
        for (int j = 0; j < i; ++j) {
          if (gap(segments[i], segments[j]) > margin) continue;
          ++near_pairs;
          EXPECT_TRUE(std::ranges::binary_search(found, j)) << i << " and " << j << " longest " << longest;
        }
      }
      EXPECT_GT(near_pairs, longest > 1 ? 100 : 0) << "longest " << longest;
    }
  }
}

TEST(SegmentGrid, answers_ascending_each_once_and_below_the_limit) {
  const std::vector<Segment> segments = random_segments(200, 30, 12);
  SegmentGrid grid(segments, 0);
  const std::vector<int> found = grid.near(segments[50], 100);
  EXPECT_GT(found.size(), 5U);
  EXPECT_TRUE(std::ranges::is_sorted(found));
  EXPECT_EQ(std::ranges::adjacent_find(found), found.end());
  EXPECT_LT(found.back(), 100);
}

TEST(SegmentGrid, far_segments_are_left_out) {
  std::vector<Segment> row;
  for (int i = 0; i < 1000; ++i) row.push_back({{1.0 * i, 0}, {1.0 * i, 1}});
  SegmentGrid grid(row, 0);
  EXPECT_LT(grid.near(row[500], 1000).size(), 50U);
}

TEST(SegmentGrid, without_segments_there_is_nothing_near) {
  SegmentGrid grid({}, 0);
  EXPECT_TRUE(grid.near({{0, 0}, {1, 1}}, 10).empty());
}

}  // namespace keyblock::segment_grid_test
