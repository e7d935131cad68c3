// Invariants of stress by closed forms: uniaxial, pure shear, hydrostatic, turned axes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/stress_invariants.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keyblock::stress_invariants_test {

TEST(StressInvariants, are_those_of_uniaxial_stress_pure_shear_and_pressure) {
  for (const double s : {1.0, 1e-9, 1e9}) {
    const StressInvariants tension = invariants_of({0, s, 0, 0});
    EXPECT_NEAR(tension.mean, s / 3, 1e-15 * s);
    EXPECT_NEAR(tension.von_mises, s, 1e-15 * s);
    EXPECT_NEAR(tension.lode_deg, -30, 1e-5);  // asin is flat there: √1e-16 rad
    const StressInvariants compression = invariants_of({0, 0, 0, -s});
    EXPECT_NEAR(compression.mean, -s / 3, 1e-15 * s);
    EXPECT_NEAR(compression.lode_deg, 30, 1e-5);
    const StressInvariants shear = invariants_of({0, 0, s, 0});
    EXPECT_EQ(shear.mean, 0);
    EXPECT_NEAR(shear.von_mises, std::numbers::sqrt3 * s, 1e-14 * s);
    EXPECT_NEAR(shear.lode_deg, 0, 1e-12);
    const StressInvariants pressure = invariants_of({-s, -s, 0, -s});
    EXPECT_EQ(pressure.mean, -s);
    EXPECT_EQ(pressure.lode_deg, 0);
    EXPECT_LT(pressure.von_mises, 1e-15 * s);
  }
}

// Principal stresses 5, 2, -4 have the deviator 4, 1, -5: q² = 3 (16 + 1 + 25) / 2 = 63, J3 = -20, J2 = 21.
TEST(StressInvariants, do_not_depend_on_the_axes) {
  const double lode = std::asin(1.5 * std::numbers::sqrt3 * 20 / std::pow(21, 1.5)) / 3 * 180 / std::numbers::pi;
  for (const double angle : {0.0, 0.3, 1.1, 2.9}) {
    const double c = std::cos(2 * angle), s = std::sin(2 * angle);
    const StressInvariants found = invariants_of({0.5 + 4.5 * c, 0.5 - 4.5 * c, 4.5 * s, 2});
    EXPECT_NEAR(found.mean, 1, 1e-14);
    EXPECT_NEAR(found.von_mises, std::sqrt(63), 1e-13);
    EXPECT_NEAR(found.lode_deg, lode, 1e-12);
  }
}

}  // namespace keyblock::stress_invariants_test
