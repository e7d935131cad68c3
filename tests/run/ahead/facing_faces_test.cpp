// Cohesion of faces that are drawn apart: they are bonded across rounding, and the run says where they are not.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/ahead/facing_faces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/standard_scenes.hpp"

namespace keyblock::facing_faces_test {
namespace {

using support::radians;

constexpr double kSlope = 30 * std::numbers::pi / 180;
constexpr double kFriction = 20;  // degrees

/// Returns a cube of 1 m, `gap` above a plane of 30 degrees.
Scene cube_on_slope(double gap, double cohesion) {
  Blocks blocks = support::block_on_slope(kSlope);
  blocks.blocks[1] = support::turned_rectangle({1, gap}, {2, 1 + gap}, -kSlope);
  Analysis analysis = support::plain_analysis(0.01, 50);
  analysis.joint_materials[0].friction_angle_deg = kFriction;
  analysis.joint_materials[0].cohesion = cohesion;
  return support::standard_scene_of(blocks, analysis, support::standard_settings(analysis));
}

/// Returns the cohesion that holds the cube: c L = W (sin α - cos α tan φ) (limit equilibrium; Hoek & Bray 1981).
double needed(const Scene& scene) {
  const double weight = scene.model.block_materials[0].unit_weight;
  return weight * (std::sin(kSlope) - std::cos(kSlope) * std::tan(radians(kFriction)));
}

double travel_in_half_a_second(double gap, double share_of_needed) {
  const double cohesion = share_of_needed * needed(cube_on_slope(gap, 0));
  StandardStepper stepper(cube_on_slope(gap, cohesion));
  const State start = stepper.state();
  support::run_to(stepper, 0.5);
  return length(support::travel(stepper, start, 1));
}

}  // namespace

TEST(FacingFaces, cohesion_holds_a_block_across_the_rounding_of_its_drawing) {
  for (const double gap : {0.0, 2.4e-6, -2.4e-6, 5e-5, -5e-5}) {
    EXPECT_LT(travel_in_half_a_second(gap, 1.001), 1e-5) << gap;
    EXPECT_GT(travel_in_half_a_second(gap, 0.999), 0.2) << gap;  // g t²/2 (sin α - cos α tan φ) = 0.227 once broken
  }
}

TEST(FacingFaces, statics_judges_cohesion_at_rest) {
  for (const double share : {0.999, 1.001}) {
    Scene scene = cube_on_slope(0, share * needed(cube_on_slope(0, 0)));
    scene.settings.standard.motion = MotionRule::equilibrium;
    StandardStepper stepper(scene);
    EXPECT_EQ(std::holds_alternative<StepFailure>(stepper.advance()), share < 1) << share;
  }
}

TEST(FacingFaces, faces_that_meet_within_the_rounding_of_a_drawing_are_not_told) {
  EXPECT_TRUE(facing_faces(cube_on_slope(2.4e-6, 5000), {}).empty());
  EXPECT_TRUE(facing_faces(cube_on_slope(-5e-5, 5000), {}).empty());
  EXPECT_TRUE(facing_faces(cube_on_slope(1e-3, 0), {}).empty());
}

TEST(FacingFaces, a_gap_without_a_bond_is_told_with_its_width) {
  const Warnings found = facing_faces(cube_on_slope(1e-3, 5000), {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name, "strength_without_bond");
  EXPECT_NE(found[0].sentence.find("a pair of faces with it is drawn up to 0.001 apart"), std::string::npos)
      << found[0].sentence;
}

TEST(FacingFaces, strength_that_acts_nowhere_is_told) {
  const Warnings found = facing_faces(cube_on_slope(0.5, 5000), {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].sentence.find("no two of its faces touch"), std::string::npos) << found[0].sentence;
}

TEST(FacingFaces, two_joint_materials_on_one_joint_are_told) {
  Scene scene = cube_on_slope(0, 0);
  EXPECT_TRUE(facing_faces(scene, {}).empty());
  scene.model.joint_materials.push_back({30, 0, 0, {}});
  EXPECT_TRUE(facing_faces(scene, {}).empty());  // no face has it
  for (const VertexIndex v : scene.model.elements[ElementIndex{1}].vertices())
    scene.model.vertices[v].joint_material = 1;
  const Warnings found = facing_faces(scene, {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name, "joint_materials_differ");
  EXPECT_NE(found[0].sentence.find("a pair of faces of one joint has"), std::string::npos) << found[0].sentence;
}

}  // namespace keyblock::facing_faces_test
