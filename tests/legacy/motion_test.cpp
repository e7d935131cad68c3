// The two rotation rules.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/step/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock::step_motion_test {

// dda-14: uncorrected rotation scales every length by sqrt(1 + r²) a step; the exact rotation keeps it.
TEST(Motion, first_order_rotation_expands_and_exact_rotation_does_not) {
  Unknowns turn = Unknowns::Zero(6);
  turn[2] = 0.1;
  const Point arm{3, 4};
  EXPECT_NEAR(length(arm + displacement(affine_basis(), turn, arm, Rotation::first_order)), 5 * std::sqrt(1.01), 1e-14);
  EXPECT_NEAR(length(arm + displacement(affine_basis(), turn, arm, Rotation::exact)), 5, 1e-14);
}

}  // namespace keyblock::step_motion_test
