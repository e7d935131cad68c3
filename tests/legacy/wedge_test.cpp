// Directions and wedges: possible contacts at a vertex.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/contact/wedge.hpp"

#include <gtest/gtest.h>

namespace keyblock::wedge_test {

TEST(Wedge, directions_of_the_four_quadrants) {
  EXPECT_NEAR(edge_direction({1, 1}, 0), 45, 1e-12);
  EXPECT_NEAR(edge_direction({-1, 1}, 0), 135, 1e-12);
  EXPECT_NEAR(edge_direction({-1, -1}, 0), 225, 1e-12);
  EXPECT_NEAR(edge_direction({1, -1}, 0), 315, 1e-12);
  EXPECT_NEAR(edge_direction({0, 1}, 0), 90, 1e-12);
}

// Legacy-rules 3: the 1e-7 rotates a vertical edge of length 1 by about 6e-6 degrees.
TEST(Wedge, berkeley_offset_turns_a_vertical_edge) {
  EXPECT_NEAR(90 - edge_direction({0, 1}, 1e-7), 5.7296e-6, 1e-9);
}

TEST(Wedge, corners_of_two_stacked_squares_may_touch) {
  const Wedge lower_right{90, 180};  // convention: material from the next to the previous edge, 90 degrees
  const Wedge upper_right{270, 360};
  EXPECT_TRUE(may_touch(lower_right, upper_right, 3));
}

TEST(Wedge, wedges_that_share_material_may_not_touch) {
  EXPECT_FALSE(may_touch({0, 90}, {45, 135}, 3));
  EXPECT_FALSE(may_touch({350, 80}, {20, 40}, 3));
}

TEST(Wedge, an_overlap_below_the_tolerance_is_let_through) {
  EXPECT_TRUE(may_touch({0, 90}, {88, 178}, 3));
  EXPECT_FALSE(may_touch({0, 90}, {86, 176}, 3));
}

}  // namespace keyblock::wedge_test
