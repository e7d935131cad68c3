// A vertex and its reference line: outside is positive, and changes are those of the moved points.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/contact/line.hpp"

#include <gtest/gtest.h>

#include "tests/support/scenes.hpp"

namespace keyblock::line_test {
namespace {

const Line kLine{{3, 4}, {0, 0}, {10, 0}};

}  // namespace

TEST(Line, distance_is_positive_on_the_left_of_the_line) {
  EXPECT_DOUBLE_EQ(kLine.distance(), 4);
  EXPECT_DOUBLE_EQ((Line{{3, -4}, {0, 0}, {10, 0}}).distance(), -4);
}

TEST(Line, projection_and_point_at_a_ratio_undo_each_other) {
  EXPECT_DOUBLE_EQ(kLine.projection(), 0.3);
  EXPECT_EQ(kLine.at(0.3), (Point{3, 0}));
}

TEST(Line, a_line_against_the_order_of_a_loop_has_its_outside_positive) {
  const ShiScene scene = support::legacy_scene(
      {{support::rectangle({0, 0}, {2, 1}), support::rectangle({0, 5}, {1, 6})}, {}, {}, {}, {}, {}},
      support::plain_analysis(1e-3, 1));
  const Line top = line_of(start(scene).state, {{4}, {3}, {2}});
  EXPECT_EQ(top.p1, (Point{0, 5}));
  EXPECT_EQ(top.p2, (Point{0, 1}));
  EXPECT_DOUBLE_EQ(top.distance(), 4);
}

// twice_area is quadratic in the motion: its central difference is exact.
TEST(Line, change_of_twice_the_area_is_its_derivative) {
  const Line line{{0.3, 1.1}, {-2, 0.2}, {3, -0.4}};
  const LineMotion u{{0.5, -0.7}, {0.2, 0.3}, {-0.4, 0.9}};
  const auto moved = [&](double t) { return Line{line.p1 + t * u.u1, line.p2 + t * u.u2, line.p3 + t * u.u3}; };
  EXPECT_NEAR(twice_area_change(line, u), (moved(1).twice_area() - moved(-1).twice_area()) / 2, 1e-14);
}

}  // namespace keyblock::line_test
