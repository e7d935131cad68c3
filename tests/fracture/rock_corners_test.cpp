// The order of the stress at corners, and the corners of a body that have one.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/rock_corners.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keyblock::rock_corners_test {
namespace {

double order_at(double degrees) {
  return stress_order(degrees * std::numbers::pi / 180);
}

// Least roots λ of opening: 0.5 at a crack, 0.512221 at 300°, 0.544484 at 270°, 0.615731 at 240° of
// rock (Seweryn & Molski 1996).
TEST(RockCorners, have_the_order_of_williams) {
  EXPECT_NEAR(order_at(360), 0.5, 1e-9);
  EXPECT_NEAR(order_at(300), 1 - 0.512221, 1e-6);
  EXPECT_NEAR(order_at(270), 1 - 0.544484, 1e-6);
  EXPECT_NEAR(order_at(240), 1 - 0.615731, 1e-6);
  EXPECT_NEAR(order_at(180), 0, 1e-9);
  EXPECT_EQ(order_at(90), 0);
}

}  // namespace
}  // namespace keyblock::rock_corners_test
