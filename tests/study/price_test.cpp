// The Pareto front of invented runs, and the choice from it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/trade/price.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace keyblock::study::price_test {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

// Front: 1 (1 s, 1e-1), 4 (2 s, 1e-3), 0 (5 s, 1e-4). 2 costs more than 4 and is worse, 3 is as good as 0 and costs
// more, 5 failed though cheap.
const std::vector<Price> kMarket{{5, 1e-4}, {1, 1e-1}, {3, 1e-2}, {8, 1e-4}, {2, 1e-3}, {0.1, kNone}};

}  // namespace

TEST(Price, the_front_holds_what_nothing_beats_cheapest_first) {
  EXPECT_EQ(pareto_front(kMarket), (std::vector<std::size_t>{1, 4, 0}));
}

TEST(Price, of_equals_the_first_is_on_the_front) {
  EXPECT_EQ(pareto_front({{1, 0.5}, {1, 0.5}, {1, 0.25}, {1, 0.25}}), (std::vector<std::size_t>{2}));
}

TEST(Price, runs_without_a_result_are_on_no_front) {
  EXPECT_TRUE(pareto_front({{1, kNone}, {2, std::nan("")}}).empty());
  EXPECT_TRUE(pareto_front({}).empty());
}

TEST(Price, over_the_front_is_measured_against_the_cheapest_as_accurate) {
  EXPECT_EQ(over_front(kMarket, 0), 1);
  EXPECT_EQ(over_front(kMarket, 2), 1.5);
  EXPECT_EQ(over_front(kMarket, 3), 1.6);
  EXPECT_EQ(over_front(kMarket, 5), kNone);
}

TEST(Price, a_budget_buys_the_most_accurate_within_it) {
  EXPECT_EQ(choice_for(kMarket, {4.0, {}}), 4U);
  EXPECT_EQ(choice_for(kMarket, {100.0, {}}), 0U);
  EXPECT_EQ(choice_for(kMarket, {0.5, {}}), std::nullopt);
}

TEST(Price, an_error_is_met_by_the_cheapest_within_it) {
  EXPECT_EQ(choice_for(kMarket, {{}, 1e-2}), 4U);
  EXPECT_EQ(choice_for(kMarket, {{}, 1e-1}), 1U);
  EXPECT_EQ(choice_for(kMarket, {{}, 1e-5}), std::nullopt);
}

// Runs that differ only by the noise of timing: one lucky run is no reason to choose it.
TEST(Price, of_runs_that_cost_the_same_but_for_noise_the_first_is_chosen) {
  const std::vector<Price> twins{{1.05, 1e-3}, {1, 1e-3}, {1.2, 1e-3}, {0.99, 2e-3}};
  EXPECT_EQ(choice_for(twins, {{}, 1e-2}), 0U);
  EXPECT_EQ(choice_for(twins, {{}, 1e-3}), 0U);
  EXPECT_EQ(choice_for(twins, {2.0, {}}), 0U);
  EXPECT_EQ(choice_for(twins, {1.02, {}}), 1U);
  EXPECT_EQ(choice_for({{1.2, 1e-3}, {1, 1e-3}}, {{}, 1e-2}), 1U);
}

TEST(Price, both_have_to_be_met) {
  EXPECT_EQ(choice_for(kMarket, {4.0, 1e-2}), 4U);
  EXPECT_EQ(choice_for(kMarket, {1.5, 1e-2}), std::nullopt);
}

}  // namespace keyblock::study::price_test
