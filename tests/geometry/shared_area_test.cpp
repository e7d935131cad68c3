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

// Two outlines of 20,000 corners one within the other's box: 4e8 products.
TEST(SharedArea, says_where_corners_crowd_too_much_to_look) {
  const auto comb = [](double low) {
    Loops loops{{{0, low - 1}, {10000, low - 1}}};
    for (int i = 20000; i >= 0; --i) loops.front().push_back({i * 0.5, low + (i % 2 == 0 ? 0.0 : 0.4)});
    return loops;
  };
  EXPECT_FALSE(shared_area({comb(0), comb(1.2)}, 1e-2).is_complete);
  EXPECT_TRUE(shared_area({square(0, 1), square(0.95, 1)}, 0.1).is_complete);
}

}  // namespace keyblock::shared_area_test
