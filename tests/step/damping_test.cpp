// Damping of block materials: rigid motion decays under mass damping, a strain mode decays under either.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "run/steppers.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::step_damping_test {
namespace {

using support::plain_analysis;
using support::rectangle;

constexpr ElementIndex kBlock{0};

void step_to(Stepper& stepper, double time, double dt) {
  while (stepper.state().time < time - dt / 2) {
    const auto made = stepper.advance();
    if (const auto* failure = std::get_if<StepFailure>(&made)) throw std::runtime_error(failure->reason);
  }
}

/// Speed after one second of a weightless square thrown at 1 m/s.
double speed_left(const char* profile, BlockBasis basis, double mass_damping, double dt) {
  Analysis analysis = plain_analysis(dt, 1);
  analysis.gravity = 0;
  analysis.block_materials[0].initial_velocity = {1, 0, 0};
  Settings settings = profile_settings(profile, analysis);
  settings.basis = basis;
  settings.mass_damping = mass_damping;
  const Scene scene = support::standard_scene_of({{rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}}, analysis, settings);
  const auto stepper = stepper_for(scene);
  step_to(*stepper, 1, dt);
  return end_velocity(stepper->state().elements[kBlock], stepper->state(), settings, 0)[0];
}

constexpr double kModulus = 5e9;
constexpr double kStress = 1e6;
// Strain mode of a free square of side 1: M_εε = ρ S_xx = ρ/12.
const double kFrequency = std::sqrt(12 * kModulus / 2500);

/// Stress xx of a released square, over its initial value kStress, after 1.3 periods.
double stress_left(const Settings& choices, int steps_a_period) {
  const double period = 2 * std::numbers::pi / kFrequency;
  const double dt = period / steps_a_period;
  Analysis analysis = plain_analysis(dt, 1);
  analysis.gravity = 0;
  analysis.block_materials[0].poissons_ratio = 0;
  analysis.block_materials[0].initial_stress = {kStress, 0, 0};
  Settings settings = support::standard_settings(analysis);
  settings.mass_damping = choices.mass_damping;
  settings.stiffness_damping = choices.stiffness_damping;
  settings.standard.strain_damping = StrainDamping::none;
  settings.standard.force_weight = 0.5;
  const Scene scene = support::standard_scene_of({{rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}}, analysis, settings);
  StandardStepper stepper(scene);
  support::run_to(stepper, 1.3 * period);
  return stepper.state().elements[kBlock].stress.xx / kStress;
}

/// x(t)/x(0) of the oscillator with damping ratio ξ, released from rest.
double oscillator(double ratio, double periods) {
  const double turn = 2 * std::numbers::pi * periods;
  const double damped = std::sqrt(1 - ratio * ratio);
  return std::exp(-ratio * turn) * (std::cos(damped * turn) + ratio / damped * std::sin(damped * turn));
}

}  // namespace

// Each step takes (1 − a dt/2)/(1 + a dt/2), of second order towards e^(−a t).
TEST(Damping, mass_damping_slows_rigid_motion_in_both_profiles) {
  const double a = 2;
  for (double dt : {0.1, 0.01}) {
    const double exact = std::pow((1 - a * dt / 2) / (1 + a * dt / 2), 1 / dt);
    EXPECT_NEAR(exact, std::exp(-a), a * a * a * dt * dt / 12 * std::exp(-a) * 1.01);
    EXPECT_NEAR(speed_left("legacy", BlockBasis::affine, a, dt), exact, 1e-10) << dt;
    EXPECT_NEAR(speed_left("standard", BlockBasis::affine, a, dt), exact, 1e-10) << dt;
    EXPECT_NEAR(speed_left("standard", BlockBasis::rigid, a, dt), exact, 1e-12) << dt;
  }
}

// ξ = (a/ω + b ω)/2. The average acceleration lengthens the period by (ω dt)²/12: at 200 steps per period and 8.2 rad a
// phase error of 7e-4.
TEST(Damping, a_strain_mode_swings_out_as_the_damped_oscillator) {
  const double ratio = 0.1;
  Settings by_mass;
  by_mass.mass_damping = 2 * ratio * kFrequency;
  by_mass.stiffness_damping.common = 0;
  Settings by_stiffness;
  by_stiffness.stiffness_damping.common = 2 * ratio / kFrequency;
  Settings undamped;
  for (const auto& [choices, damping] : {std::pair{by_mass, ratio}, {by_stiffness, ratio}, {undamped, 0.0}}) {
    const double coarse = stress_left(choices, 200) - oscillator(damping, 1.3);
    const double fine = stress_left(choices, 400) - oscillator(damping, 1.3);
    EXPECT_LT(std::abs(coarse), 1e-3) << damping;
    EXPECT_NEAR(coarse / fine, 4, 0.2) << damping;
  }
}

// By material: the second block of two has none.
TEST(Damping, materials_are_damped_apart) {
  Analysis analysis = plain_analysis(0.01, 1);
  analysis.gravity = 0;
  analysis.block_materials[0].initial_velocity = {1, 0, 0};
  analysis.block_materials.push_back(analysis.block_materials[0]);
  BlockPolygon second = rectangle({0, 10}, {1, 11});
  second.material = 1;
  for (const char* profile : {"legacy", "standard"}) {
    Settings settings = profile_settings(profile, analysis);
    settings.mass_damping.own[0] = 3;
    const Scene scene =
        support::standard_scene_of({{rectangle({0, 0}, {1, 1}), second}, {}, {}, {}, {}, {}}, analysis, settings);
    const auto stepper = stepper_for(scene);
    step_to(*stepper, 1, 0.01);
    const double decay = (1 - 0.015) / (1 + 0.015);
    const double way = 0.01 * (1 / (1 + 0.015)) * (1 - std::pow(decay, 100)) / (1 - decay);
    EXPECT_NEAR(stepper->state().elements[{0}].centroid.x - 0.5, way, 1e-10) << profile;
    EXPECT_NEAR(stepper->state().elements[{1}].centroid.x - 0.5, 1, 1e-10) << profile;
  }
}

// A step of 50/ω₁ cannot follow the strains of a square that is thrown on a rough floor: they would reverse in each.
TEST(Damping, a_block_that_has_stopped_keeps_no_velocity) {
  const double dt = 50 / kFrequency;
  Analysis analysis = plain_analysis(dt, 1);
  analysis.block_materials[0].initial_velocity = {1, -1, 0};
  analysis.joint_materials[0].friction_angle_deg = 40;
  Blocks blocks;
  blocks.blocks = {rectangle({-5, -1}, {5, 0}), rectangle({0, 0.02}, {1, 1.02})};
  blocks.fixed_points = {{{-4, -0.5}, 0, {}}, {{4, -0.5}, 0, {}}};
  const Scene scene = support::standard_scene_of(blocks, analysis, support::standard_settings(analysis));
  StandardStepper stepper(scene);
  support::run_to(stepper, 200 * dt);
  const UnknownBlock v = stepper.state().elements[ElementIndex{1}].velocity;
  EXPECT_LT(v.cwiseAbs().maxCoeff(), 1e-9);
}

}  // namespace keyblock::step_damping_test
