// Sequences whose limit and order are known.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/trade/extrapolation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock::study::extrapolation_test {
namespace {

/// (3, -4) + h^p (1, 2) at h = 0.2, 0.1, 0.05.
std::array<std::vector<double>, 3> of_order(double p) {
  std::array<std::vector<double>, 3> values;
  double h = 0.2;
  for (auto& v : values) {
    v = {3 + std::pow(h, p), -4 + 2 * std::pow(h, p)};
    h /= 2;
  }
  return values;
}

}  // namespace

TEST(Extrapolation, finds_order_and_limit_of_a_pure_power) {
  for (const double p : {0.5, 1.0, 2.0, 4.0}) {
    const Limit limit = limit_of(of_order(p), Refined::mesh);
    EXPECT_TRUE(limit.is_extrapolated);
    EXPECT_NEAR(*limit.order, p, 1e-6) << p;
    EXPECT_NEAR(limit.values[0], 3, 1e-9) << p;
    EXPECT_NEAR(limit.values[1], -4, 1e-9) << p;
    // Error of the finest run: h^p sqrt(1 + 4) over 5. A rate above second order is not trusted.
    const double careful = p > 2 ? (std::exp2(p) - 1) / 3 : 1;
    EXPECT_NEAR(limit.uncertainty, careful * std::pow(0.05, p) * std::sqrt(5.0) / 5, 1e-8) << p;
  }
}

// The trapezoidal rule for the integral of e^x over 0..1 is of second order with terms beyond: 2, 4, 8 intervals give
// the limit e - 1 to Boole's error.
TEST(Extrapolation, brings_the_trapezoidal_rule_nearer_to_the_integral) {
  std::array<std::vector<double>, 3> values;
  int intervals = 2;
  for (auto& v : values) {
    double sum = 0;
    for (int i = 0; i <= intervals; ++i)
      sum += std::exp(static_cast<double>(i) / intervals) * (i == 0 || i == intervals ? 0.5 : 1) / intervals;
    v = {sum};
    intervals *= 2;
  }
  const double exact = std::exp(1) - 1;
  const Limit limit = limit_of(values, Refined::mesh);
  EXPECT_NEAR(*limit.order, 2, 0.02);
  EXPECT_LT(std::abs(limit.values[0] - exact), 0.02 * std::abs(values[2][0] - exact));
}

// 1 - 0.6 h + h² at h = 1, 1/2, 1/4: differences shrink by 12, as those of order 3.6 would, which the method has not.
TEST(Extrapolation, takes_out_first_and_second_order_where_they_cancel) {
  const auto u = [](double h) { return std::vector<double>{1 - 0.6 * h + h * h}; };
  const Limit limit = limit_of({u(1), u(0.5), u(0.25)}, Refined::step);
  EXPECT_GT(*limit.order, 3);
  EXPECT_NEAR(limit.values[0], 1, 1e-14);
  EXPECT_GE(limit.uncertainty, std::abs(u(0.25)[0] - 1) * (1 - 1e-12));
}

// Friction stops a block 1.5 m away, v²/(2 g tan φ), in steps of which the last is cut short somewhere. Its error is h²
// times another factor in each run (displacements of this program). Differences shrink by nine.
TEST(Extrapolation, does_not_take_differences_that_shrink_by_chance_for_less_error) {
  const Limit limit = limit_of({{{1.50000164062}, {1.50000024609}, {1.50000009668}}}, Refined::step);
  EXPECT_GT(*limit.order, 3);
  EXPECT_GE(limit.uncertainty, std::abs(limit.values[0] - 1.5) / 1.5);
}

TEST(Extrapolation, keeps_the_finest_where_differences_do_not_shrink) {
  const Limit limit = limit_of({{{1.0}, {2.0}, {1.0}}}, Refined::step);
  EXPECT_FALSE(limit.is_extrapolated);
  EXPECT_NEAR(*limit.order, 0, 1e-12);
  EXPECT_EQ(limit.values, std::vector<double>{1.0});
  EXPECT_EQ(limit.uncertainty, 1);
}

TEST(Extrapolation, has_no_order_where_all_three_are_the_same) {
  const Limit limit = limit_of({{{1.0, 2.0}, {1.0, 2.0}, {1.0, 2.0}}}, Refined::step);
  EXPECT_FALSE(limit.order);
  EXPECT_FALSE(limit.is_extrapolated);
  EXPECT_EQ(limit.uncertainty, 0);
}

TEST(Extrapolation, distances_are_relative_but_to_nothing) {
  EXPECT_DOUBLE_EQ(relative_distance({3, 5}, {3, 4}), 0.2);
  EXPECT_DOUBLE_EQ(relative_distance({3, 4}, {0, 0}), 5 / std::sqrt(2.0));
}

}  // namespace keyblock::study::extrapolation_test
