// How far a search is, told where no step ends.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/progress/headway.hpp"

#include <gtest/gtest.h>

namespace keyblock::headway_test {

TEST(Headway, a_fall_of_half_the_orders_of_magnitude_is_half_the_way) {
  EXPECT_NEAR(share_of_fall(1, 1e-4, 1e-8), 0.5, 1e-12);
  EXPECT_EQ(share_of_fall(1, 10, 1e-8), 0) << "farther off than at first";
  EXPECT_EQ(share_of_fall(1, 1e-9, 1e-8), 1);
  EXPECT_EQ(share_of_fall(1, 0, 1e-8), 0) << "not known";
  EXPECT_EQ(share_of_fall(1e-9, 1e-9, 1e-8), 0) << "there at once";
}

TEST(Headway, what_is_told_stays_until_it_is_forgotten) {
  tell_headway("search", 1.5);
  EXPECT_STREQ(headway().what, "search");
  EXPECT_EQ(headway().share, 1);
  forget_headway();
  EXPECT_EQ(headway().what, nullptr);
}

}  // namespace keyblock::headway_test
