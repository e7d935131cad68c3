// Signs are right where floating point cannot decide, and stations keep the exact order of crossings.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/predicates.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock::predicates_test {
namespace {

constexpr double kUlpOfHalf = 0x1p-53;

}  // namespace

TEST(Predicates, orientation_sees_a_single_unit_in_the_last_place) {
  // The classic near-collinear grid about (0.5, 0.5) against the line through (12, 12) and (24, 24).
  for (int i = 0; i < 16; ++i) {
    for (int j = 0; j < 16; ++j) {
      const Point p{0.5 + i * kUlpOfHalf, 0.5 + j * kUlpOfHalf};
      const int expected = (p.y > p.x) - (p.y < p.x);
      EXPECT_EQ(orientation({12, 12}, {24, 24}, p), expected);
      EXPECT_EQ(orientation({24, 24}, {12, 12}, p), -expected);
    }
  }
}

TEST(Predicates, orientation_is_exact_over_far_apart_exponents) {
  EXPECT_EQ(orientation({0, 0}, {1e20, 1e20}, {1, 1 + 0x1p-52}), 1);
  EXPECT_EQ(orientation({0, 0}, {1e20, 1e20}, {1e-30, 1e-30}), 0);
  EXPECT_EQ(orientation({1e7, 1e7}, {1e7 + 1, 1e7 + 1}, {1e7 + 1e-9, 1e7}), -1);
}

TEST(Predicates, turn_compares_directions_of_separate_segments) {
  EXPECT_EQ(turn({0, 0}, {3, 1}, {5, 5}, {8, 6}), 0);
  EXPECT_EQ(turn({0, 0}, {3, 1}, {5, 5}, {8, std::nextafter(6, 7)}), 1);
  EXPECT_EQ(turn({0, 0}, {3, 1}, {5, 5}, {8, std::nextafter(6, 5)}), -1);
}

TEST(Predicates, agreement_is_the_sign_of_the_dot_product) {
  EXPECT_EQ(agreement({0, 0}, {1, 2}, {7, 7}, {9, 6}), 0);
  EXPECT_EQ(agreement({0, 0}, {1, 2}, {7, 7}, {9, std::nextafter(6, 7)}), 1);
}

TEST(Predicates, three_lines_through_one_rational_point_have_equal_stations) {
  const Segment base{{0, 0}, {3, 1}};
  const Segment through_third{{0, 1}, {2, -1}};  // meets the base in (3/4, 1/4)
  const Segment also_through{{1, 0}, {-1, 2}};   // the same line
  const Segment steeper{{0.5, 0}, {1, 0.5}};     // slope 1 through (3/4, 1/4)
  EXPECT_EQ(compare_stations(base, through_third, steeper), 0);
  EXPECT_EQ(compare_stations(base, also_through, steeper), 0);
  EXPECT_EQ(compare_stations(base, {{0.5, 0}, {1, std::nextafter(0.5, 1)}}, through_third), -1);
}

TEST(Predicates, bounds_of_stations_hold) {
  const Segment base{{0, 0}, {3, 1}};
  const Segment mark{{0, 1}, {2, -1}};
  const Station t = station(base, mark);
  EXPECT_NEAR(t.value, 0.25, t.error);
  EXPECT_LT(t.error, 1e-15);
  EXPECT_TRUE(is_order_certain(t, station(base, {{0, 1.1}, {2, -0.9}})));
}

TEST(Predicates, exact_station_serves_almost_parallel_lines) {
  const Segment base{{0, 0}, {1, 1}};
  const Segment mark{{0, 0x1p-60}, {1, 1 - 0x1p-53}};
  // y = 2^-60 + x (1 - 2^-53 - 2^-60) meets y = x at x = 2^-60 / (2^-53 + 2^-60) = 1 / (2^7 + 1).
  EXPECT_DOUBLE_EQ(exact_station(base, mark).value, 1.0 / 129);
}

TEST(Predicates, foot_of_a_point_is_a_station) {
  const Segment base{{1, 1}, {3, 1}};
  EXPECT_EQ(station(base, {{2, 5}, {2, 5}}).value, 0.5);
  EXPECT_EQ(compare_stations(base, {{2, 5}, {2, 5}}, {{2, 0}, {2, 9}}), 0);
}

}  // namespace keyblock::predicates_test
