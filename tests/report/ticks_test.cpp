// Axes end on round ticks and their labels tell neighbours apart, for any size and offset of the data.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/ticks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace keyblock::report::ticks_test {

TEST(Ticks, round_down_gives_one_two_or_five_times_a_power_of_ten) {
  EXPECT_DOUBLE_EQ(round_down(0.3), 0.2);
  EXPECT_DOUBLE_EQ(round_down(1), 1);
  EXPECT_DOUBLE_EQ(round_down(7e6), 5e6);
  EXPECT_DOUBLE_EQ(round_down(0.001), 0.001);
}

TEST(Ticks, a_second_is_divided_into_tenths) {
  const Axis axis = make_axis(0, 1, 10);
  EXPECT_EQ(axis.labels,
            (std::vector<std::string>{"0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1.0"}));
}

TEST(Ticks, long_numbers_get_a_power_of_ten) {
  EXPECT_EQ(make_axis(-4.9e-6, 0, 5).exponent, -6);
  EXPECT_EQ(make_axis(0, 2.5e7, 5).exponent, 6);
}

TEST(Ticks, any_data_is_covered_by_few_ticks_with_different_labels) {
  const double cases[][2] = {{0, 0},     {3, 3},   {-1e-9, 2e-9}, {1e7, 1e7 + 1}, {-5, -4.999},
                             {0, 1e300}, {-1, 17}, {0.3, 0.7},    {1e7, 1e7}};
  for (const auto& [low, high] : cases) {
    const Axis axis = make_axis(low, high, 6);
    EXPECT_LE(axis.low(), low + 1e-9 * (axis.high() - axis.low()));
    EXPECT_GE(axis.high(), high - 1e-9 * (axis.high() - axis.low()));
    EXPECT_LE(axis.ticks.size(), 12U) << low << ' ' << high;
    EXPECT_GE(axis.ticks.size(), 2U);
    EXPECT_EQ(std::set(axis.labels.begin(), axis.labels.end()).size(), axis.labels.size()) << low << ' ' << high;
  }
}

// The smallest number divided by five is 0, and the span of the largest is infinite.
TEST(Ticks, the_least_and_the_greatest_numbers_have_an_axis_too) {
  const double cases[][2] = {{0, 5e-324},      {-5e-324, 5e-324},   {0, 1e-300},
                             {1e-291, 3e-291}, {-1.7e308, 1.7e308}, {0, 1.7e308}};
  for (const auto& [low, high] : cases) {
    const Axis axis = make_axis(low, high, 6);
    ASSERT_GE(axis.ticks.size(), 2U) << low << ' ' << high;
    EXPECT_LE(axis.ticks.size(), 12U) << low << ' ' << high;
    EXPECT_LT(axis.low(), axis.high());
    EXPECT_TRUE(std::isfinite(axis.high() - axis.low()));
    EXPECT_EQ(axis.labels.size(), axis.ticks.size());
  }
}

}  // namespace keyblock::report::ticks_test
