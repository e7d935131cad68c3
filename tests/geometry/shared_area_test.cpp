// Pairs of squares that lie in one another, by hand.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/shared_area.hpp"

#include <gtest/gtest.h>

namespace keyblock::shared_area_test {
namespace {

Loops square(double x, double side) {
  return {{{x, 0}, {x + side, 0}, {x + side, side}, {x, side}}};
}

}  // namespace

TEST(SharedArea, squares_side_by_side_share_nothing) {
  EXPECT_EQ(shared_area({square(0, 1), square(1, 1), square(2, 1)}, 1e-6).pairs, 0);
}

TEST(SharedArea, is_that_of_the_first_pair_over_the_smaller_body) {
  const SharedArea shared = shared_area({square(0, 4), square(3.5, 1), square(10, 1), square(10, 1)}, 0.1);
  EXPECT_EQ(shared.first, 0);
  EXPECT_EQ(shared.second, 1);
  EXPECT_DOUBLE_EQ(shared.share, 0.5);
  EXPECT_EQ(shared.pairs, 2);
}

TEST(SharedArea, pairs_below_the_least_share_do_not_count) {
  EXPECT_EQ(shared_area({square(0, 1), square(0.95, 1)}, 0.1).pairs, 0);
}

}  // namespace keyblock::shared_area_test
