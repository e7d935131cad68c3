// The affine basis is Shi's block: translation, rotation and three strains about the centroid.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/basis.hpp"

#include <gtest/gtest.h>

namespace keyblock::basis_test {

TEST(AffineBasis, displacement_is_the_complete_first_order_field) {
  Unknowns d(6);
  d << 1, 2, 0.1, 0.01, 0.02, 0.04;
  const Point u = affine_basis().displacement(d, {3, 5});
  EXPECT_NEAR(u.x, 1 - 0.1 * 5 + 0.01 * 3 + 0.04 * 5 / 2, 1e-15);
  EXPECT_NEAR(u.y, 2 + 0.1 * 3 + 0.02 * 5 + 0.04 * 3 / 2, 1e-15);
}

TEST(AffineBasis, strain_operator_picks_the_three_strains) {
  Unknowns d(6);
  d << 1, 2, 0.1, 0.01, 0.02, 0.04;
  EXPECT_TRUE((affine_basis().strain() * d).isApprox(Eigen::Vector3d(0.01, 0.02, 0.04)));
}

}  // namespace keyblock::basis_test
