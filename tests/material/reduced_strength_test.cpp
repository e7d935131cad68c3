// Strength divided by a factor: tangents, parts of flow that stay, values after a change.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/reduced_strength.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keyblock::reduced_strength_test {
namespace {

double tangent(double degrees) {
  return std::tan(degrees * std::numbers::pi / 180);
}

Strength coulomb(double friction, double dilation) {
  Strength strength;
  strength.values = {10, friction, dilation, 5, 3};
  return strength;
}

}  // namespace

TEST(ReducedStrength, divides_tangents_and_strengths) {
  const Strength weaker = reduced(coulomb(30, 30), 1.5);
  EXPECT_NEAR(tangent(weaker.values.friction_deg), tangent(30) / 1.5, 1e-14);
  EXPECT_EQ(weaker.values.dilation_deg, weaker.values.friction_deg);
  EXPECT_DOUBLE_EQ(weaker.values.cohesion, 10 / 1.5);
  EXPECT_DOUBLE_EQ(weaker.values.yield_stress, 5 / 1.5);
  EXPECT_DOUBLE_EQ(*weaker.values.tensile_strength, 2);
}

TEST(ReducedStrength, flow_below_friction_keeps_its_dilation_until_friction_meets_it) {
  EXPECT_EQ(reduced(coulomb(30, 10), 1.5).values.dilation_deg, 10);
  const Strength met = reduced(coulomb(30, 10), 5);
  EXPECT_EQ(met.values.dilation_deg, met.values.friction_deg);
  EXPECT_LT(met.values.dilation_deg, 10);
  EXPECT_TRUE(flows_below_friction(coulomb(30, 10)));
  EXPECT_FALSE(flows_below_friction(coulomb(30, 30)));
}

TEST(ReducedStrength, reduces_what_is_left_after_a_change_and_keeps_how_it_gets_there) {
  Strength softens = coulomb(30, 30);
  softens.change = StrengthChange{{4, 20, 0, 2, 1}, 0.01, 0};
  const Strength weaker = reduced(softens, 2);
  EXPECT_DOUBLE_EQ(weaker.change->values.cohesion, 2);
  EXPECT_NEAR(tangent(weaker.change->values.friction_deg), tangent(20) / 2, 1e-14);
  EXPECT_EQ(weaker.change->plastic_strain, 0.01);
  EXPECT_TRUE(flows_below_friction(softens));  // after the change
}

TEST(ReducedStrength, the_factor_1_changes_nothing) {
  EXPECT_EQ(reduced(coulomb(33.3, 12.1), 1), coulomb(33.3, 12.1));
}

}  // namespace keyblock::reduced_strength_test
