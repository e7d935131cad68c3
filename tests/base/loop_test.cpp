// Loops give the same result on any number of threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/loop.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "base/context.hpp"

namespace keyblock::loop_test {
namespace {

constexpr std::size_t kCount = 40 * kLoopRange + 7;

/// Restores the number of threads.
class Loop : public ::testing::Test {
 protected:
  ~Loop() override { context().use_threads(0); }
};

double alternating_sum() {
  const auto [sum, squares] = sums_over<2>(kCount, [](std::size_t i) {
    const double x = std::sin(static_cast<double>(i)) * std::pow(10.0, static_cast<int>(i % 17) - 8);
    return std::array{x, x * x};
  });
  return sum + squares;
}

}  // namespace

TEST_F(Loop, every_entry_has_its_turn_once) {
  for (const int threads : {1, 2, 4}) {
    context().use_threads(threads);
    for (const Work weight : {Work::heavy, Work::light}) {
      std::vector<int> turns(kCount);
      for_each_entry(
          kCount, [&](std::size_t i) { ++turns[i]; }, weight);
      EXPECT_EQ(turns, std::vector<int>(kCount, 1)) << threads;
    }
  }
}

TEST_F(Loop, sums_have_the_same_bits_on_any_number_of_threads) {
  context().use_threads(1);
  const double one = alternating_sum();
  for (const int threads : {2, 3, 4}) {
    context().use_threads(threads);
    EXPECT_EQ(alternating_sum(), one) << threads;
  }
}

TEST_F(Loop, what_work_throws_comes_through) {
  for (const int threads : {1, 4}) {
    context().use_threads(threads);
    EXPECT_THROW(for_each_entry(kCount,
                                [](std::size_t i) {
                                  if (i == 3000) throw std::runtime_error("no");
                                }),
                 std::runtime_error);
  }
}

}  // namespace keyblock::loop_test
