// Fits of another shape than the measured curve give a warning, fits with noise about the law do not.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/fit/fit_doubts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "study/fit/curve_fit.hpp"

namespace keyblock::study::fit_doubts_test {
namespace {

template <class Stress>
MeasuredPairs sampled(int count, double last, Stress stress, double noise = 0, unsigned seed = 1) {
  std::mt19937_64 dice(seed);
  std::normal_distribution<double> normal;
  MeasuredPairs m{"curve.csv", {}, {}, {}};
  for (int i = 0; i < count; ++i) {
    m.x.push_back(last * i / (count - 1));
    m.y.push_back(stress(m.x.back()) + noise * normal(dice));
    m.lines.push_back(i + 2);
  }
  return m;
}

Warnings doubts_of(const MeasuredPairs& m) {
  const CurveFit fit = fit_curve(m, CompressionSign::found);
  return joined(doubts_of_curve(m), doubts_of_fit(m, fit.agreement));
}

bool has(const Warnings& warnings, const std::string& name) {
  return std::ranges::count(warnings, name, &Warning::name) > 0;
}

/// 30 at a strain of 1e-3, then down again to nothing.
double peaked(double strain) {
  return 30 - 3e4 * std::abs(strain - 1e-3);
}

}  // namespace

// The best plateau of a triangle leaves 58 % of the variance: R² was 0.418.
TEST(FitDoubts, a_curve_with_a_peak_that_softens_is_told_at_its_peak) {
  const Warnings warnings = doubts_of(sampled(20, 1.9e-3, peaked));
  ASSERT_TRUE(has(warnings, "softening"));
  ASSERT_TRUE(has(warnings, "poor_fit"));
  EXPECT_EQ(warnings.front().place.line, 12);
  EXPECT_NE(warnings.front().sentence.find("from 30 at strain 0.001 to 3 "), std::string::npos)
      << warnings.front().sentence;
  EXPECT_NE(warnings.back().sentence.find("R² is 0.418"), std::string::npos) << warnings.back().sentence;
}

// σ = 80 sin of a quarter and more turns: R² is 0.99 and more, yet points lie on one side.
TEST(FitDoubts, a_curve_of_another_shape_is_told_whatever_its_r_squared) {
  const MeasuredPairs round = sampled(60, 4e-3, [](double e) { return 80 * std::sin(e / 2.6e-3); });
  EXPECT_GT(fit_curve(round, CompressionSign::found).agreement.r_squared, 0.95);
  EXPECT_TRUE(has(doubts_of(round), "poor_fit"));
  EXPECT_FALSE(has(doubts_of(round), "softening"));
}

// A hundred curves with a noise of 3 % of their strength.
TEST(FitDoubts, noise_about_the_law_is_not_doubted) {
  const BilinearCurve bench{10e3, 30e3, 5e-4, 80};
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const Warnings warnings = doubts_of(sampled(
        60, 4e-3, [&](double e) { return bench.stress(e); }, 2.4, seed));
    EXPECT_TRUE(warnings.empty()) << seed << ": " << warnings.front().sentence;
  }
}

}  // namespace keyblock::study::fit_doubts_test
