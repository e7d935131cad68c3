// Times of steps and factors of a search are short decimals, without tails of round-off.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/decimals.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace keyblock::decimals_test {

TEST(Decimals, sums_and_products_of_short_decimals_are_short) {
  EXPECT_NE(fmt::format("{}", 0.1 + 0.2), "0.3");
  EXPECT_EQ(fmt::format("{}", short_decimal(0.1 + 0.2)), "0.3");
  EXPECT_EQ(fmt::format("{}", short_decimal(3 * 0.003)), "0.009");
  EXPECT_EQ(short_decimal(-1e-300), -1e-300);
  EXPECT_EQ(short_decimal(std::numeric_limits<double>::max()), std::numeric_limits<double>::max());
  EXPECT_TRUE(std::isnan(short_decimal(std::nan(""))));
}

TEST(Decimals, times_of_a_hundred_thousand_steps_have_no_tails) {
  for (const double dt : {0.001, 0.0007, 0.003, 1e-7}) {
    double time = 0;
    for (int step = 1; step <= 100'000; ++step) time = time_after(time, dt);
    EXPECT_EQ(fmt::format("{}", time), fmt::format("{:.12g}", 1e5 * dt));
  }
}

// A step too small for 15 digits still moves time on.
TEST(Decimals, tiny_steps_are_not_lost_by_rounding) {
  const double dt = 1e-10, time = time_after(1e5, dt);
  EXPECT_EQ(time, 1e5 + dt);
  EXPECT_GT(time, 1e5);
}

TEST(Decimals, wall_times_have_at_most_six_decimals) {
  EXPECT_EQ(fmt::format("{}", to_microseconds(0.0023833969999999998)), "0.002383");
}

}  // namespace keyblock::decimals_test
