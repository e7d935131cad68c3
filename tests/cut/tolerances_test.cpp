// Tolerances scale with the drawing and vanish with its ratio.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/lines/tolerances.hpp"

#include <gtest/gtest.h>

#include <string>

#include "base/error.hpp"
#include "tests/cut/drawings.hpp"

namespace keyblock::tolerances_test {

// w0 = 1.02 max(H/2, (W/2)/1.3), merge 1.25 e0 w0 (legacy-formats 3.6).
TEST(Tolerances, scale_is_that_of_the_old_block_cutter) {
  EXPECT_DOUBLE_EQ(cut_tolerances(drawing_of(rectangle_sides({0, 0}, {2, 10}))).scale, 1.02 * 5);
  const CutTolerances wide = cut_tolerances(drawing_of(rectangle_sides({-10, 3}, {16, 5}), 0.01));
  EXPECT_DOUBLE_EQ(wide.scale, 1.02 * 10);
  EXPECT_DOUBLE_EQ(wide.merge, 1.25 * 0.01 * 10.2);
  EXPECT_DOUBLE_EQ(wide.near_pass, 0.01 * 10.2);
}

TEST(Tolerances, without_a_ratio_the_arrangement_is_exact) {
  const CutTolerances exact = cut_tolerances(drawing_of(rectangle_sides({0, 0}, {2, 10}), 0));
  EXPECT_TRUE(exact.is_exact());
  EXPECT_EQ(exact.near_pass, 0);
  EXPECT_EQ(exact.reach_ratio, 0);
  EXPECT_EQ(exact.round_off, 0);
  EXPECT_GT(exact.inset, 0) << "fixed points are inside the edge all the same";
  EXPECT_TRUE(cut_tolerances(Drawing{}).is_exact());
}

namespace {

/// A square of 10 m cut by joints every metre, with the last line's start at `start`.
Drawing jointed_square(Point start) {
  std::vector<Segment> lines = rectangle_sides({0, 0}, {10, 10});
  for (int i = 1; i < 10; ++i) lines.push_back({{1.0 * i, 0}, {1.0 * i, 10}});
  lines.push_back({start, {10, 5}});
  return drawing_of(lines, 0.001);
}

std::string refusal(const Drawing& drawing) {
  try {
    require_small_merging(drawing, cut_tolerances(drawing));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST(Tolerances, a_line_that_reaches_a_hundred_times_too_far_is_named) {
  for (const Point p : {Point{0, 5000}, Point{-5000, 5}, Point{0, 5e5}, Point{5e7, -5e7}})
    EXPECT_TRUE(refusal(jointed_square(p)).starts_with("drawing:14: error: ")) << p.x << ", " << p.y;
  EXPECT_EQ(refusal(jointed_square({0, 5})), "");
  EXPECT_EQ(refusal(jointed_square({0, 50})), "") << "the merging distance is 3 % of a line";
}

TEST(Tolerances, lines_shorter_than_the_merging_distance_are_refused_whatever_reaches_farthest) {
  std::vector<Segment> lines = rectangle_sides({0, 0}, {1000, 1000});
  for (int i = 0; i < 60; ++i) lines.push_back({{500.0 + i, 500}, {500.5 + i, 500}});
  EXPECT_NE(refusal(drawing_of(lines, 0.001)), "");
  EXPECT_EQ(refusal(drawing_of(lines, 0.0001)), "");
  EXPECT_EQ(refusal(drawing_of(lines, 0)), "") << "nothing is merged";
}

TEST(Tolerances, far_from_the_origin_round_off_grows_with_the_coordinates) {
  const double near = cut_tolerances(drawing_of(rectangle_sides({0, 0}, {2, 2}))).round_off;
  const double far = cut_tolerances(drawing_of(rectangle_sides({1e9, 0}, {1e9 + 2, 2}))).round_off;
  EXPECT_LT(near, 2e-9);
  EXPECT_GT(far, 1e-6);  // the spacing of doubles at 1e9 is 1.2e-7
}

}  // namespace keyblock::tolerances_test
