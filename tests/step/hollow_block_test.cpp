// Blocks with holes in profile `standard`: contact inside and outside.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/support/ledger_runs.hpp"

namespace keyblock::hollow_block_test {
namespace {

using support::plain_analysis;
using support::rectangle;
using support::standard_scene_of;
using support::standard_settings;

constexpr double kDensity = 2500;
constexpr double kGravity = 9.81;

BlockLoop clockwise(Point low, Point high) {
  return {{low, 0}, {{low.x, high.y}, 0}, {high, 0}, {{high.x, low.y}, 0}};
}

Analysis heavy(double dt, int steps) {
  Analysis analysis = plain_analysis(dt, steps);
  analysis.block_materials[0].density = kDensity;
  analysis.block_materials[0].unit_weight = kDensity * kGravity;
  return analysis;
}

// A frame of 3 × 3 with a hole of 2 × 2 on a fixed floor, and a square metre in the hole, `above` its sill.
Blocks frame_and_block(double above) {
  Blocks scene;
  scene.blocks = {rectangle({-2, -1}, {5, 0}), rectangle({0, 0}, {3, 3}),
                  rectangle({1, 0.5 + above}, {2, 1.5 + above})};
  scene.blocks[1].holes = {clockwise({0.5, 0.5}, {2.5, 2.5})};
  scene.fixed_points = {{{-1.5, -0.5}, 0, {}}, {{4.5, -0.5}, 0, {}}};
  return scene;
}

// Springs of 10 E carry both: (5 + 1) ρ g on the floor, ρ g on the sill.
TEST(HollowBlock, bears_what_lies_in_its_hole) {
  const Analysis analysis = heavy(2e-3, 500);
  Settings settings = standard_settings(analysis);
  settings.standard.enforcement = Enforcement::lagrange;
  StandardStepper stepper(standard_scene_of(frame_and_block(0), analysis, settings));
  const State start = stepper.state();
  support::run_to(stepper, 1);
  for (const int block : {1, 2}) EXPECT_LT(length(support::travel(stepper, start, block)), 1e-9) << block;
  const double stress = stepper.state().elements[ElementIndex{2}].stress.yy;
  EXPECT_NEAR(stress, -kDensity * kGravity / 2, 1e-6 * kDensity * kGravity) << "mean of a block under its weight";
}

// From a height of 0.4 m the block lands after √(2 h / g) = 0.2856 s, and stays on the sill.
TEST(HollowBlock, catches_what_falls_in_its_hole) {
  constexpr double kHeight = 0.4;
  const Analysis analysis = heavy(1e-3, 600);
  StandardStepper stepper(standard_scene_of(frame_and_block(kHeight), analysis, standard_settings(analysis)));
  const double from = stepper.state().elements[ElementIndex{2}].centroid.y;
  support::run_to(stepper, 0.25);
  EXPECT_NEAR(from - stepper.state().elements[ElementIndex{2}].centroid.y, kGravity * 0.25 * 0.25 / 2, 1e-6);
  support::run_to(stepper, 0.6);
  EXPECT_NEAR(from - stepper.state().elements[ElementIndex{2}].centroid.y, kHeight, 1e-4);
  EXPECT_NEAR(stepper.state().elements[ElementIndex{1}].centroid.y, 1.5, 1e-4);
}

// Polar moment of a square ring about its centre: (3⁴ − 2⁴)/6 per unit mass of area.
TEST(HollowBlock, turns_with_the_inertia_of_a_ring) {
  const Blocks scene = frame_and_block(0.3);
  const Analysis analysis = heavy(1e-3, 1);
  const Scene made = standard_scene_of(scene, analysis, standard_settings(analysis));
  const StandardScene standard = standard_scene(made.model, made.settings);
  const Body& ring = standard.bodies()[ElementIndex{1}];
  EXPECT_NEAR(ring.mass(0, 0), 5 * kDensity, 1e-9 * kDensity);
  EXPECT_NEAR(ring.mass(2, 2), (81 - 16) / 6.0 * kDensity, 1e-9 * kDensity);
}

}  // namespace
}  // namespace keyblock::hollow_block_test
