// Drawn lengths have the requested mean and scatter, and depend on the seed alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/joints/random_value.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock::random_value_test {
namespace {

constexpr int kDraws = 40000;

struct Sample {
  double mean = 0;
  double deviation = 0;
};

Sample sample(const RandomLength& length) {
  const RandomStream stream(7, 1);
  double sum = 0, squares = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double value = draw(length, stream);
    EXPECT_GT(value, 0);
    sum += value;
    squares += value * value;
  }
  const double mean = sum / kDraws;
  return {mean, std::sqrt(squares / kDraws - mean * mean)};
}

}  // namespace

TEST(RandomValue, lengths_have_the_mean_and_scatter_asked_for) {
  for (const auto law : {Distribution::normal, Distribution::lognormal, Distribution::exponential}) {
    const bool is_exponential = law == Distribution::exponential;
    const double deviation = 2.5 * (is_exponential ? 1 : 0.2);
    const Sample found = sample({2.5, 0.2, law});
    EXPECT_NEAR(found.mean, 2.5, 3 * deviation / std::sqrt(kDraws));
    EXPECT_NEAR(found.deviation, deviation, 0.03 * deviation);
  }
}

TEST(RandomValue, normal_lengths_stay_above_zero_and_their_mean_rises_by_what_is_stated) {
  // E[x | x > 0] = m + s φ(m/s) / Φ(m/s); at s = m: 1.28760 m.
  EXPECT_NEAR(sample({1, 1, Distribution::normal}).mean, 1.28760, 3 * 0.8 / std::sqrt(kDraws));
}

TEST(RandomValue, no_scatter_gives_the_mean_and_a_mean_of_zero_gives_zero) {
  const RandomStream stream(1, 1);
  EXPECT_EQ(draw({3, 0, Distribution::lognormal}, stream), 3);
  EXPECT_EQ(draw({3, 0, Distribution::normal}, stream), 3);
  EXPECT_EQ(draw({0, 0.5, Distribution::lognormal}, stream), 0);
}

TEST(RandomValue, streams_follow_from_seed_and_number) {
  const auto first = [](std::uint64_t seed, std::uint64_t number) { return RandomStream(seed, number).share(); };
  EXPECT_EQ(first(1, 1), first(1, 1));
  EXPECT_NE(first(1, 1), first(1, 2));
  EXPECT_NE(first(1, 2), first(2, 1));
}

}  // namespace keyblock::random_value_test
