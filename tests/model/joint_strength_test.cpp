// One factor on the strength of all joints.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setup/joint_strength.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock::joint_strength_test {
namespace {

Model jointed() {
  Model model;
  model.joint_materials = {{30, 100, 40, {}}, {0, 0, 7, {}}};
  return model;
}

}  // namespace

TEST(JointStrength, tangent_of_friction_cohesion_and_tension_take_the_factor) {
  const Model weak = with_joint_strength(jointed(), 0.5);
  EXPECT_NEAR(weak.joint_materials[0].friction_tangent(), 0.5 / std::sqrt(3), 1e-15);
  EXPECT_EQ(weak.joint_materials[0].cohesion, 50);
  EXPECT_EQ(weak.joint_materials[0].tensile_strength, 20);
  EXPECT_EQ(weak.joint_materials[1].friction_angle_deg, 0);
  EXPECT_EQ(weak.joint_materials[1].tensile_strength, 3.5);
  EXPECT_EQ(with_joint_strength(jointed(), 1).joint_materials[0].friction_angle_deg, 30);
  EXPECT_EQ(with_joint_strength(jointed(), 0).joint_materials[0].friction_angle_deg, 0);
}

}  // namespace keyblock::joint_strength_test
