// Points under exact rotation and strain, and their derivative.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock::kinematics_test {
namespace {

Unknowns moved() {
  Unknowns q(6);
  q << 1, 2, 0.7, 0.01, -0.02, 0.04;
  return q;
}

Point position(const Unknowns& q, Point offset) {
  return BlockMap(affine_basis(), q, {}).place(offset);
}

}  // namespace

TEST(Kinematics, the_jacobian_is_the_derivative_of_the_position) {
  constexpr double kStep = 1e-6;
  const Point offset{0.3, -0.8};
  const DisplacementOperator j = jacobian(affine_basis(), moved(), offset);
  for (int i = 0; i < 6; ++i) {
    Unknowns forward = moved();
    Unknowns backward = moved();
    forward[i] += kStep;
    backward[i] -= kStep;
    const Point d = 1 / (2 * kStep) * (position(forward, offset) - position(backward, offset));
    EXPECT_NEAR(j(0, i), d.x, 1e-8) << i;
    EXPECT_NEAR(j(1, i), d.y, 1e-8) << i;
  }
}

// x = c + R (I + ε) X with figures: R of 0.7 rad, (I + ε) X = (0.3 · 1.01 + 0.02 · −0.8, 0.02 · 0.3 − 0.8 · 0.98).
TEST(Kinematics, a_point_is_turned_after_it_is_stretched) {
  const Point stretched{0.287, -0.778};
  const Point at = position(moved(), {0.3, -0.8});
  EXPECT_NEAR(at.x, 1 + std::cos(0.7) * stretched.x - std::sin(0.7) * stretched.y, 1e-15);
  EXPECT_NEAR(at.y, 2 + std::sin(0.7) * stretched.x + std::cos(0.7) * stretched.y, 1e-15);
}

TEST(Kinematics, the_material_point_at_a_place_is_found_again) {
  const Unknowns q = moved();
  const Point offset{0.3, -0.8};
  const Point back = BlockMap(affine_basis(), q, {}).offset(position(q, offset));
  EXPECT_NEAR(distance(back, offset), 0, 1e-15);
}

TEST(Kinematics, rigid_and_fixed_points_keep_their_distances) {
  Unknowns q(3);
  q << 5, 6, 2.5;
  EXPECT_NEAR(distance(BlockMap(rigid_basis(), q, {}).place({3, 4}), {5, 6}), 5, 4e-15);
  EXPECT_EQ(jacobian(fixed_basis(), Unknowns(0), {3, 4}).cols(), 0);
  EXPECT_EQ(angle_of(fixed_basis(), Unknowns(0)), 0);
}

}  // namespace keyblock::kinematics_test
