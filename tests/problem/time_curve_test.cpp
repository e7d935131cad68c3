// A time curve is linear between its rows and constant outside them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/time_curve.hpp"

#include <gtest/gtest.h>

namespace keyblock::time_curve_test {

TEST(TimeCurve, is_linear_between_rows_and_held_outside) {
  const TimeCurve curve{{0, 2, 3}, {{0, 0}, {10, -4}, {0, 0}}, {}};
  EXPECT_EQ(curve.at(1), (Point{5, -2}));
  EXPECT_EQ(curve.at(2.5), (Point{5, -2}));
  EXPECT_EQ(curve.at(-1), (Point{0, 0}));
  EXPECT_EQ(curve.at(9), (Point{0, 0}));
}

TEST(TimeCurve, empty_curve_is_zero) {
  EXPECT_EQ(TimeCurve{}.at(1), (Point{0, 0}));
}

}  // namespace keyblock::time_curve_test
