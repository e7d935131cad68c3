// Choices of materials reach the steps: velocity carried over, restitution, enforcement.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "run/steppers.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::material_choices_test {
namespace {

using support::plain_analysis;
using support::rectangle;
using support::run_to;
using support::standard_scene_of;

BlockPolygon with_joint(BlockPolygon block, int joint) {
  for (BlockVertex& corner : block.outer) corner.joint_material = joint;
  return block;
}

/// Two floors, each with a block of its own joint material `gap` above it.
Blocks two_pairs(double gap) {
  Blocks scene;
  for (int i : {0, 1}) {
    const double x = 10 * i;
    scene.blocks.push_back(with_joint(rectangle({x, -1}, {x + 4, 0}), i));
    scene.blocks.push_back(with_joint(rectangle({x + 1, gap}, {x + 2, 1 + gap}), i));
    scene.fixed_points.push_back({{x + 1, -0.5}, 2 * i, {}});
    scene.fixed_points.push_back({{x + 3, -0.5}, 2 * i, {}});
  }
  return scene;
}

Analysis two_joints(double dt) {
  Analysis analysis = plain_analysis(dt, 1);
  analysis.joint_materials.resize(2);
  return analysis;
}

}  // namespace

// g t²/2 for the first, for the second n steps of g dt²/2 from rest.
TEST(MaterialChoices, a_material_that_carries_no_velocity_over_creeps_beside_one_that_falls) {
  const double dt = 0.01;
  Analysis analysis = plain_analysis(dt, 1);
  analysis.block_materials.push_back(analysis.block_materials[0]);
  BlockPolygon second = rectangle({10, 0}, {11, 1});
  second.material = 1;
  for (const char* profile : {"legacy", "standard"}) {
    Settings settings = profile_settings(profile, analysis);
    settings.velocity_carry_over.own[1] = 0;
    const Scene scene =
        standard_scene_of({{rectangle({0, 0}, {1, 1}), second}, {}, {}, {}, {}, {}}, analysis, settings);
    const auto stepper = stepper_for(scene);
    for (int i = 0; i < 20; ++i) ASSERT_TRUE(std::holds_alternative<StepReport>(stepper->advance()));
    EXPECT_NEAR(stepper->state().elements[{0}].centroid.y - 0.5, -9.81 * 0.2 * 0.2 / 2, 1e-10) << profile;
    EXPECT_NEAR(stepper->state().elements[{1}].centroid.y - 0.5, -20 * 9.81 * dt * dt / 2, 1e-10) << profile;
  }
}

// Without weight the speed after the impact is e times the one before.
TEST(MaterialChoices, each_joint_material_rebounds_by_its_own_restitution) {
  Analysis analysis = two_joints(1e-3);
  analysis.gravity = 0;
  analysis.block_materials[0].initial_velocity = {0, -1, 0};
  Settings settings = support::standard_settings(analysis);
  settings.basis = BlockBasis::rigid;
  settings.standard.restitution = 0.8;
  settings.standard.restitution.own[1] = 0.3;
  const Scene scene = standard_scene_of(two_pairs(0.0123), analysis, settings);
  StandardStepper stepper(scene);
  run_to(stepper, 0.03);
  EXPECT_NEAR(stepper.state().elements[{1}].velocity[1], 0.8, 1e-9);
  EXPECT_NEAR(stepper.state().elements[{3}].velocity[1], 0.3, 1e-9);
}

// A rigid block of weight W on two springs p settles by W/2p; on multipliers it does not.
TEST(MaterialChoices, joints_with_springs_give_and_joints_with_multipliers_do_not) {
  const Analysis analysis = two_joints(1e-3);
  Settings settings = support::standard_settings(analysis);
  settings.basis = BlockBasis::rigid;
  settings.standard.enforcement.own[1] = Enforcement::penalty;
  const Scene scene = standard_scene_of(two_pairs(0), analysis, settings);
  StandardStepper stepper(scene);
  run_to(stepper, 0.05);
  EXPECT_NEAR(stepper.state().elements[{1}].centroid.y, 0.5, 1e-12);
  EXPECT_NEAR(stepper.state().elements[{3}].centroid.y, 0.5 - 24525 / (2 * settings.contact_penalty), 1e-12);
}

}  // namespace keyblock::material_choices_test
