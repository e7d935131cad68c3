// The mass matrix against its closed form on a rectangle of 2 by 1.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/mass_matrix.hpp"

#include <gtest/gtest.h>

namespace keyblock::mass_matrix_test {

// ∫ρ TᵀT over b × h about its centre: mass rho b h, rotary inertia m (b² + h²)/12, strain inertia m b²/12 and so on.
TEST(MassMatrix, of_a_rectangle_is_its_closed_form) {
  const Moments moments{2, 0, 0, 2 * 4.0 / 12, 2 * 1.0 / 12, 0};
  const UnknownBlock mass = mass_matrix(affine_basis(), moments, 2500);
  const double m = 2500 * 2;
  EXPECT_NEAR(mass(0, 0), m, 1e-8);
  EXPECT_NEAR(mass(2, 2), m * (4 + 1) / 12, 1e-7);
  EXPECT_NEAR(mass(3, 3), m * 4 / 12, 1e-7);
  EXPECT_NEAR(mass(4, 4), m * 1 / 12, 1e-7);
  EXPECT_NEAR(mass(5, 5), m * (4 + 1) / 48, 1e-7);
  EXPECT_NEAR(mass(2, 5), m * (4 - 1) / 24, 1e-7);
  EXPECT_NEAR(mass(0, 2), 0, 1e-8);
}

}  // namespace keyblock::mass_matrix_test
