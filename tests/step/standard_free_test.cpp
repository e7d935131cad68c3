// Free motion under Dynamics::standard: fall, spin, and the stress that rotates with the block.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>

#include "geometry/polygon.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::standard_free_test {
namespace {

using support::plain_analysis;
using support::rectangle;
using support::run_to;
using support::standard_scene_of;
using support::standard_settings;

constexpr ElementIndex kBlock{0};

Scene free_block(const Analysis& analysis, BlockBasis basis) {
  Settings settings = standard_settings(analysis);
  settings.basis = basis;
  return standard_scene_of({{rectangle({0, 10}, {1, 11})}, {}, {}, {}, {}, {}}, analysis, settings);
}

}  // namespace

// dda-01: s = g t²/2 and v = g t, exact for constant acceleration at any step.
TEST(StandardFree, free_fall_is_exact) {
  for (BlockBasis basis : {BlockBasis::rigid, BlockBasis::affine}) {
    for (double dt : {1e-3, 1e-2, 0.1}) {
      const Scene scene = free_block(plain_analysis(dt, 1), basis);
      StandardStepper stepper(scene);
      run_to(stepper, 1);
      const ElementState& block = stepper.state().elements[kBlock];
      EXPECT_NEAR((block.centroid.y - 10.5) / -4.905, 1, 1e-10) << "dt " << dt;
      EXPECT_NEAR(block.velocity[1] / -9.81, 1, 1e-10) << "dt " << dt;
      EXPECT_NEAR(block.centroid.x, 0.5, 1e-12);
      EXPECT_NEAR(block.rotation, 0, 1e-15);
    }
  }
}

// dda-14: the first-order update grows the area by (1 + dθ²)^n; exact rotation keeps it.
TEST(StandardFree, spin_keeps_the_area_whatever_the_angle_of_a_step) {
  for (BlockBasis basis : {BlockBasis::rigid, BlockBasis::affine}) {
    for (const auto& [turn, steps] :
         std::array<std::pair<double, int>, 4>{{{0.1, 63}, {0.05, 126}, {0.01, 628}, {0.001, 6283}}}) {
      Analysis analysis = plain_analysis(turn / 0.1, 1);
      analysis.gravity = 0;
      analysis.block_materials[0].initial_velocity = {0, 0, 0.1};
      const Scene scene = free_block(analysis, basis);
      StandardStepper stepper(scene);
      for (int i = 0; i < steps; ++i) ASSERT_TRUE(std::holds_alternative<StepReport>(stepper.advance()));
      const State& state = stepper.state();
      EXPECT_NEAR(state.elements[kBlock].rotation, turn * steps, 1e-9);
      EXPECT_NEAR(area(state.vertices), 1, 5e-9) << "turn " << turn;
      EXPECT_NEAR(distance(state.vertices[{0}], state.vertices[{1}]), 1, 5e-9) << "turn " << turn;
    }
  }
}

// A tensor in axes rotated by the angle of the block: invariants stay, components follow R σ Rᵀ.
TEST(StandardFree, stress_turns_with_the_block) {
  Analysis analysis = plain_analysis(0.01, 1);
  analysis.gravity = 0;
  analysis.block_materials[0].initial_velocity = {0, 0, 1};
  analysis.block_materials[0].initial_stress = {3e5, -1e5, 5e4};
  const Scene scene = free_block(analysis, BlockBasis::rigid);  // strains locked: only the rotation shows
  StandardStepper stepper(scene);
  run_to(stepper, 1);
  const Stress s = stepper.state().elements[kBlock].stress;
  EXPECT_NEAR(s.xx + s.yy, 2e5, 1e-4);
  EXPECT_NEAR(s.xx * s.yy - s.xy * s.xy, -3e10 - 25e8, 1);
  const double c = std::cos(1.0);
  const double n = std::sin(1.0);
  EXPECT_NEAR(s.xx, c * c * 3e5 - 2 * c * n * 5e4 - n * n * 1e5, 1e-4);
}

// No force does work: a free affine block set spinning keeps its momentum and angular rate.
TEST(StandardFree, a_thrown_spinning_block_keeps_its_momentum) {
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.gravity = 0;
  analysis.block_materials[0].initial_velocity = {1, 2, 3};
  const Scene scene = free_block(analysis, BlockBasis::affine);
  StandardStepper stepper(scene);
  run_to(stepper, 1);
  const ElementState& block = stepper.state().elements[kBlock];
  EXPECT_NEAR(block.velocity[0], 1, 1e-11);
  EXPECT_NEAR(block.velocity[1], 2, 1e-11);
  EXPECT_NEAR(block.velocity[2], 3, 1e-11);
  EXPECT_NEAR(block.centroid.x, 1.5, 1e-10);
  EXPECT_NEAR(block.rotation, 3, 1e-10);
}

// A linear strain beyond −1 is no block: released from a tension of twice the modulus, its ends would pass through one
// another.
TEST(StandardFree, a_block_that_turns_inside_out_is_a_failure) {
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.gravity = 0;
  analysis.block_materials[0].youngs_modulus = 1e6;
  analysis.block_materials[0].poissons_ratio = 0;
  analysis.block_materials[0].initial_stress = {0, 2e6, 0};
  const Scene scene =
      standard_scene_of({{rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}}, analysis, standard_settings(analysis));
  StandardStepper stepper(scene);
  try {
    run_to(stepper, 1);
    FAIL();
  } catch (const std::runtime_error& failure) {
    EXPECT_NE(std::string(failure.what()).find("block 1 is turned inside out or no longer finite"), std::string::npos)
        << failure.what();
  }
  EXPECT_GT(stepper.state().elements[ElementIndex{0}].moments.area, 0);
}

// Newmark's rule with β below γ/2 blows up where ω dt is above 1/√(γ/2 − β): here ω dt is some 28.
TEST(StandardFree, an_integrator_that_blows_up_is_a_failure) {
  for (StepControl control : {StepControl::constant, StepControl::shi, StepControl::error}) {
    Analysis analysis = plain_analysis(1e-2, 1);
    analysis.gravity = 0;
    analysis.block_materials[0].initial_stress = {0, 1e3, 0};
    Settings settings = standard_settings(analysis);
    settings.standard.integrator = Integrator::newmark;
    settings.standard.newmark_beta = 0.05;
    settings.standard.strain_damping = StrainDamping::none;
    settings.standard.least_step_share = 1;
    settings.step_control = control;
    const Scene scene = standard_scene_of({{rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}}, analysis, settings);
    StandardStepper stepper(scene);
    EXPECT_THROW(run_to(stepper, 30), std::runtime_error);
  }
}

}  // namespace keyblock::standard_free_test
