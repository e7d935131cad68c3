// The near-tip field: gradients against differences, stress against Hooke's law, equilibrium, traction-free faces.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/near_tip_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/near_tip_displacement.hpp"

namespace keyblock::near_tip_field_test {
namespace {

constexpr StressIntensity kMixed{1.3, -0.7};

Eigen::Vector2d displacement_at(const PlaneElasticity& rock, double x, double y) {
  return support::near_tip_displacement(rock, kMixed, std::hypot(x, y), std::atan2(y, x));
}

TEST(NearTipField, gradients_are_those_of_the_displacement) {
  for (const bool is_strain : {false, true}) {
    const PlaneElasticity rock{2.5, 0.22, is_strain};
    for (const double theta : {-3.0, -1.2, 0.1, 0.9, 2.6}) {
      const double x = 0.7 * std::cos(theta), y = 0.7 * std::sin(theta), h = 1e-5;
      const Eigen::Matrix2d gradient = near_tip_gradient(rock, kMixed, 0.7, theta);
      const Eigen::Vector2d by_x = (displacement_at(rock, x + h, y) - displacement_at(rock, x - h, y)) / (2 * h);
      const Eigen::Vector2d by_y = (displacement_at(rock, x, y + h) - displacement_at(rock, x, y - h)) / (2 * h);
      EXPECT_LT((gradient.col(0) - by_x).norm(), 1e-9) << theta;
      EXPECT_LT((gradient.col(1) - by_y).norm(), 1e-9) << theta;
    }
  }
}

TEST(NearTipField, stress_is_that_of_the_strain) {
  for (const bool is_strain : {false, true}) {
    const PlaneElasticity rock{2.5, 0.22, is_strain};
    const double e = rock.youngs_modulus, nu = rock.poissons_ratio;
    const double lambda = is_strain ? e * nu / ((1 + nu) * (1 - 2 * nu)) : e * nu / (1 - nu * nu);
    for (const double theta : {-2.9, -0.4, 0.3, 1.9}) {
      const Eigen::Matrix2d g = near_tip_gradient(rock, kMixed, 0.31, theta);
      const Eigen::Vector3d stress = near_tip_stress(kMixed, 0.31, theta);
      const double mu = rock.shear_modulus();
      EXPECT_NEAR(stress(0), lambda * g.trace() + 2 * mu * g(0, 0), 1e-12);
      EXPECT_NEAR(stress(1), lambda * g.trace() + 2 * mu * g(1, 1), 1e-12);
      EXPECT_NEAR(stress(2), mu * (g(0, 1) + g(1, 0)), 1e-12);
    }
  }
}

TEST(NearTipField, faces_bear_nothing_and_the_rock_ahead_what_the_factors_say) {
  for (const double side : {1.0, -1.0}) {
    const Eigen::Vector3d face = near_tip_stress(kMixed, 0.2, side * std::numbers::pi);
    EXPECT_NEAR(face(1), 0, 1e-15);
    EXPECT_NEAR(face(2), 0, 1e-15);
  }
  const Eigen::Vector3d ahead = near_tip_stress(kMixed, 0.2, 0);
  EXPECT_NEAR(ahead(1) * std::sqrt(2 * std::numbers::pi * 0.2), kMixed.mode_1, 1e-14);
  EXPECT_NEAR(ahead(2) * std::sqrt(2 * std::numbers::pi * 0.2), kMixed.mode_2, 1e-14);
}

}  // namespace
}  // namespace keyblock::near_tip_field_test
