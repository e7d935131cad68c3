// A free block under a given acceleration: constant a, s = a t²/2; linear a = c t, s = c t³/6.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "run/steppers.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::step_body_acceleration_test {
namespace {

using support::plain_analysis;

constexpr ElementIndex kBlock{0};

struct Travel {
  Point way;
  Unknowns velocity;
};

/// One second of a free square without gravity, under profile, basis and acceleration as given.
Travel second_of(const char* profile, BlockBasis basis, double dt, const BodyAcceleration& acceleration) {
  Analysis analysis = plain_analysis(dt, 1);
  analysis.gravity = 0;
  analysis.allowed_displacement_ratio = 100;
  Settings settings = profile_settings(profile, analysis);
  settings.basis = basis;
  settings.body_acceleration = acceleration;
  const Scene scene =
      support::standard_scene_of({{support::rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}}, analysis, settings);
  const std::unique_ptr<Stepper> stepper = stepper_for(scene);
  while (stepper->state().time < 1 - dt / 2) {
    const auto made = stepper->advance();
    if (const auto* failure = std::get_if<StepFailure>(&made)) throw std::runtime_error(failure->reason);
  }
  const ElementState& block = stepper->state().elements[kBlock];
  return {block.centroid - Point{0.5, 0.5}, block.velocity};
}

BodyAcceleration growing(double rate) {
  return {{}, {{0, 10}, {{0, 0}, {10 * rate, 0}}, {}}, {}};
}

}  // namespace

// Exact at any step: the step has constant acceleration.
TEST(GivenAcceleration, constant_acceleration_moves_a_free_block_by_half_a_t_squared) {
  for (const char* profile : {"legacy", "standard"}) {
    for (double dt : {1e-3, 1e-2, 0.1}) {
      const Travel made = second_of(profile, BlockBasis::affine, dt, {{3, -2}, {}, {}});
      EXPECT_NEAR(made.way.x, 1.5, 1e-10) << profile << ' ' << dt;
      EXPECT_NEAR(made.way.y, -1, 1e-10) << profile << ' ' << dt;
    }
  }
  const Travel rigid = second_of("standard", BlockBasis::rigid, 0.1, {{3, -2}, {}, {}});
  EXPECT_NEAR(rigid.way.x, 1.5, 1e-12);
  EXPECT_NEAR(rigid.velocity[0], 3, 1e-12);
}

// Sampled at mid-step, v = c t²/2 is exact and s = c t³/6 + c t dt²/12: the trapezoid of a parabola.
TEST(GivenAcceleration, linear_acceleration_is_second_order_in_standard) {
  const double c = 6;
  for (BlockBasis basis : {BlockBasis::rigid, BlockBasis::affine}) {
    for (double dt : {0.01, 0.05, 0.1}) {
      const Travel made = second_of("standard", basis, dt, growing(c));
      EXPECT_NEAR(made.velocity[0], c / 2, 1e-10) << dt;
      EXPECT_NEAR(made.way.x, c / 6 + c * dt * dt / 12, 1e-10) << dt;
    }
  }
}

// A blow of 4 ms gives v = 1 m/s in steps from a quarter of it to 25 times as long. The way is v (1 - 0.505), to the
// place of the blow within its step.
TEST(GivenAcceleration, a_blow_shorter_than_a_step_gives_its_whole_impulse) {
  const BodyAcceleration blow{{}, {{0.503, 0.505, 0.507}, {{0, 0}, {500, 0}, {0, 0}}, {}}, {}};
  for (const double dt : {0.001, 0.003, 0.005, 0.01, 0.1}) {
    const Travel made = second_of("standard", BlockBasis::affine, dt, blow);
    EXPECT_NEAR(made.velocity[0], 1, 1e-9) << dt;
    EXPECT_NEAR(made.way.x, std::round(1 / dt) * dt - 0.505, dt / 2) << dt;
  }
}

// Taken at the end of the step, v = c t (t + dt)/2 and s = Σ dt (v_k + v_k+1)/2 = c (t³/6 + t² dt/4 + t dt²/12): first
// order, as point loads are in Shi's step.
TEST(GivenAcceleration, linear_acceleration_is_first_order_in_legacy) {
  const double c = 6;
  for (double dt : {0.01, 0.05, 0.1}) {
    const Travel made = second_of("legacy", BlockBasis::affine, dt, growing(c));
    EXPECT_NEAR(made.way.x, c * (1.0 / 6 + dt / 4 + dt * dt / 12), 1e-9) << dt;
  }
}

}  // namespace keyblock::step_body_acceleration_test
