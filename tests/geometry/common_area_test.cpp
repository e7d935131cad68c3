// Areas that bodies share, compared with areas found by inspection: notched, hollow, rotated, and neighbours with a
// common side only.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/common_area.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace keyblock::common_area_test {
namespace {

std::vector<Point> box(Point low, Point high) {
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

std::vector<Point> reversed(std::vector<Point> loop) {
  std::ranges::reverse(loop);
  return loop;
}

const Loops kUnit = {box({0, 0}, {1, 1})};
/// An L of area 3 in a square of side 2.
const Loops kNotched = {{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
/// A frame of area 12 about a hole of side 2.
const Loops kFrame = {box({0, 0}, {4, 4}), reversed(box({1, 1}, {3, 3}))};

}  // namespace

TEST(CommonArea, is_that_of_the_part_within_both) {
  EXPECT_NEAR(common_area(kUnit, {box({0.5, -1}, {3, 0.5})}), 0.25, 1e-15);
  EXPECT_NEAR(common_area(kUnit, kUnit), 1, 1e-15);
  EXPECT_NEAR(common_area(kNotched, {box({0.5, 0.5}, {1.5, 1.5})}), 0.75, 1e-15);
  EXPECT_NEAR(common_area({box({0.5, 0.5}, {1.5, 1.5})}, kNotched), 0.75, 1e-15);
  // A plus of two bars: no corner of either lies in the other.
  EXPECT_NEAR(common_area({box({-5, -1}, {5, 1})}, {box({-1, -5}, {1, 5})}), 4, 1e-14);
}

TEST(CommonArea, of_neighbours_is_nothing) {
  EXPECT_EQ(common_area(kUnit, {box({1, 0}, {2, 1})}), 0);
  EXPECT_EQ(common_area(kUnit, {box({1, 1}, {2, 2})}), 0);
  EXPECT_NEAR(common_area(kNotched, {box({1, 1}, {2, 2})}), 0, 1e-15) << "it fills the notch";
  EXPECT_NEAR(common_area(kFrame, {box({1, 1}, {3, 3})}), 0, 1e-15) << "it fills the hole";
}

TEST(CommonArea, a_hole_is_no_part_of_its_body) {
  EXPECT_NEAR(common_area(kFrame, {box({0.5, 1.5}, {3.5, 2.5})}), 1, 1e-15);
  EXPECT_NEAR(common_area(kFrame, kFrame), 12, 1e-14);
}

}  // namespace keyblock::common_area_test
