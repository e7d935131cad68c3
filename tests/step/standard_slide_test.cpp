// A block on a slope under Coulomb friction, compared with the closed forms of benchmarks dda-03, dda-04 and dda-05.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

#include "tests/support/standard_scenes.hpp"

namespace keyblock::standard_slide_test {
namespace {

using support::block_on_slope;
using support::plain_analysis;
using support::radians;
using support::run_to;
using support::standard_scene_of;
using support::standard_settings;

constexpr double kGravity = 9.81;

// Slope and friction, degrees: the pairs of dda-03 that slide.
constexpr std::array<std::pair<double, double>, 19> kSliding{{{15, 0},
                                                              {15, 5},
                                                              {15, 10},
                                                              {30, 0},
                                                              {30, 5},
                                                              {30, 10},
                                                              {30, 15},
                                                              {30, 20},
                                                              {30, 25},
                                                              {30, 29.99},
                                                              {45, 0},
                                                              {45, 10},
                                                              {45, 20},
                                                              {45, 30},
                                                              {45, 40},
                                                              {60, 0},
                                                              {60, 20},
                                                              {60, 35},
                                                              {60, 40}}};

struct Choice {
  BlockBasis basis;
  Enforcement enforcement;
  double penalty_over_modulus;
};

constexpr std::array<Choice, 6> kChoices{{{BlockBasis::rigid, Enforcement::lagrange, 10},
                                          {BlockBasis::rigid, Enforcement::penalty, 10},
                                          {BlockBasis::rigid, Enforcement::penalty, 100},
                                          {BlockBasis::affine, Enforcement::lagrange, 10},
                                          {BlockBasis::affine, Enforcement::penalty, 10},
                                          {BlockBasis::affine, Enforcement::penalty, 100}}};

std::string name_of(const Choice& choice) {
  return fmt::format("{} {}", choice.basis == BlockBasis::rigid ? "rigid" : "affine",
                     choice.enforcement == Enforcement::lagrange
                         ? "multipliers"
                         : fmt::format("penalty {} E", choice.penalty_over_modulus));
}

Scene slope_scene(double slope_deg, double friction_deg, double dt, const Choice& choice, double speed = 0,
                  double gap = 0) {
  Analysis analysis = plain_analysis(dt, 1);
  analysis.block_materials[0].density = 2600;
  analysis.penalty_factor = choice.penalty_over_modulus;
  analysis.joint_materials[0].friction_angle_deg = friction_deg;
  const double a = radians(slope_deg);
  analysis.block_materials[0].initial_velocity = {speed * std::cos(a), -speed * std::sin(a), 0};
  Settings settings = standard_settings(analysis);
  settings.basis = choice.basis;
  settings.standard.enforcement = choice.enforcement;
  Blocks blocks = block_on_slope(a);
  for (BlockVertex& corner : blocks.blocks[1].outer)
    corner.position = corner.position + gap * Point{std::sin(a), std::cos(a)};
  return standard_scene_of(blocks, analysis, settings);
}

double down_slope(Point p, double slope_deg) {
  return dot(p, {std::cos(radians(slope_deg)), -std::sin(radians(slope_deg))});
}

double slip(const StandardStepper& stepper, const State& start, double slope_deg) {
  return down_slope(support::travel(stepper, start, 1), slope_deg);
}

Point velocity(const StandardStepper& stepper) {
  const Unknowns& v = stepper.state().elements[ElementIndex{1}].velocity;
  return {v[0], v[1]};
}

}  // namespace

// dda-03: s = g/2 (sin a - cos a tan phi) t².
TEST(StandardSlide, a_sliding_block_follows_the_closed_form_for_every_choice_of_basis_and_contact) {
  for (const Choice& choice : kChoices) {
    for (double dt : {1e-3, 1e-2}) {
      double worst = 0;
      for (const auto& [slope, friction] : kSliding) {
        const Scene scene = slope_scene(slope, friction, dt, choice);
        StandardStepper stepper(scene);
        const State start = stepper.state();
        for (double t : {0.5, 1.0}) {
          run_to(stepper, t);
          const double a = radians(slope);
          const double expected = kGravity / 2 * (std::sin(a) - std::cos(a) * std::tan(radians(friction))) * t * t;
          const double error = slip(stepper, start, slope) - expected;
          EXPECT_LE(std::abs(error), 1e-6 * expected + 1e-7)
              << name_of(choice) << ", dt " << dt << ", slope " << slope << ", friction " << friction << ", t " << t;
          worst = std::max(worst, std::abs(error));
        }
      }
      RecordProperty(fmt::format("{}, dt {}", name_of(choice), dt), fmt::format("{:.1e} m", worst));
    }
  }
}

// The estimate is then the motion itself, and rows and matrix of the first iteration stay.
TEST(StandardSlide, a_block_that_goes_on_with_the_acceleration_it_has_takes_one_system_a_step) {
  for (const Choice& choice : kChoices) {
    StandardStepper stepper(slope_scene(30, 20, 1e-2, choice));
    run_to(stepper, 0.2);
    for (int i = 0; i < 20; ++i) {
      const auto made = stepper.advance();
      const auto* report = std::get_if<StepReport>(&made);
      ASSERT_NE(report, nullptr) << name_of(choice);
      EXPECT_LE(report->passes, 1) << name_of(choice) << ", step " << report->step;
    }
  }
}

namespace {

constexpr double kHalfGravity = kGravity / 2;

// Falls freely until the gap is closed at time c, then slides as if it had always done so: the impulse that takes the
// normal speed g cos α c has friction too.
double way_after_closing(double gap, double slope_deg, double friction_deg) {
  const double a = radians(slope_deg);
  const double sliding = kGravity * (std::sin(a) - std::cos(a) * std::tan(radians(friction_deg)));
  const double closing = std::sqrt(gap / (kHalfGravity * std::cos(a)));
  const double left = 1 - closing;
  return kHalfGravity * std::sin(a) * closing * closing + sliding * (closing * left + left * left / 2);
}

}  // namespace

// Gaps that end in an impact, in a closing slower than one, or at once: the step in which they close may lose friction
// of its own length alone.
TEST(StandardSlide, a_block_drawn_above_its_slope_loses_no_friction_while_the_gap_closes) {
  for (const Choice& choice : kChoices) {
    for (double dt : {1e-2, 2e-3, 5e-4}) {
      for (double gap : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
        const Scene scene = slope_scene(30, 20, dt, choice, 0, gap);
        StandardStepper stepper(scene);
        const State start = stepper.state();
        run_to(stepper, 1);
        const double closing_speed = std::sqrt(2 * kGravity * std::cos(radians(30)) * gap);
        EXPECT_NEAR(slip(stepper, start, 30), way_after_closing(gap, 30, 20),
                    1e-5 + std::tan(radians(20)) * closing_speed * dt)
            << name_of(choice) << ", dt " << dt << ", gap " << gap;
      }
    }
  }
}

// Springs hold the place in the step that closes the gap, and the velocity in the next. A velocity that the first left
// would drive the block in by as much as it fell.
TEST(StandardSlide, a_block_that_falls_less_than_in_one_step_rests_where_it_meets_the_floor) {
  for (const Choice& choice : kChoices) {
    for (double gap : {1e-5, 1e-4, 2e-4, 1e-3, 1.9e-3}) {
      const Scene scene = slope_scene(0, 20, 2e-2, choice, 0, gap);
      StandardStepper stepper(scene);
      const State start = stepper.state();
      for (int step = 1; step <= 20; ++step) {
        run_to(stepper, step * 2e-2);
        EXPECT_NEAR(support::travel(stepper, start, 1).y, -gap, 1e-5)
            << name_of(choice) << ", gap " << gap << ", step " << step;
      }
    }
  }
}

// A sliding contact stops within a step. Its way in that step is slip, not a stretch of the spring, which would throw
// the block back. The way is v²/(2 g tan phi), to that of one step.
TEST(StandardSlide, a_block_that_friction_stops_on_level_ground_stays) {
  for (const Choice& choice : kChoices) {
    for (double dt : {2e-2, 5e-3, 1e-3}) {
      for (const double friction : {20.0, 45.0}) {
        constexpr double kSpeed = 0.3;
        constexpr double kVibration =
            1e-3;  // of an affine block whose friction ends; a stretch would give 5e-3 at 1 ms
        StandardStepper stepper(slope_scene(0, friction, dt, choice, kSpeed));
        const State start = stepper.state();
        const double time = kSpeed / (kGravity * std::tan(radians(friction)));
        run_to(stepper, dt * (2 + std::ceil(time / dt)));
        const std::string what = fmt::format("{}, dt {}, friction {}", name_of(choice), dt, friction);
        const double way = slip(stepper, start, 0);
        EXPECT_NEAR(way, kSpeed * time / 2, kSpeed * dt) << what;
        for (int step = 0; step < 10; ++step) {
          run_to(stepper, stepper.state().time + dt);
          EXPECT_LE(length(velocity(stepper)), kVibration) << what;
        }
        EXPECT_NEAR(slip(stepper, start, 0), way, 1e-5) << what;
      }
    }
  }
}

// dda-04: at the friction angle of the slope and above, the block stays.
TEST(StandardSlide, a_block_at_its_friction_angle_and_above_does_not_creep) {
  for (const Choice& choice : kChoices) {
    for (double dt : {1e-3, 1e-2}) {
      for (double friction : {30.0, 30.01, 30.1, 31.0, 35.0}) {
        const Scene scene = slope_scene(30, friction, dt, choice);
        StandardStepper stepper(scene);
        const State start = stepper.state();
        run_to(stepper, 1);
        const double half_way = std::abs(slip(stepper, start, 30));
        run_to(stepper, 2);
        const double end = std::abs(slip(stepper, start, 30));
        EXPECT_LE(end, 1e-7) << name_of(choice) << ", dt " << dt << ", friction " << friction;
        EXPECT_LE(end - half_way, 1e-8) << name_of(choice) << ", dt " << dt << ", friction " << friction;
      }
    }
  }
}

namespace {

// Error at 0.5 s of a block at (45, 40), where an undamped block flutters.
double flutter_error(double dt, StrainDamping damping) {
  Scene scene = slope_scene(45, 40, dt, {BlockBasis::affine, Enforcement::lagrange, 10});
  scene.settings.standard.strain_damping = damping;
  StandardStepper stepper(scene);
  const State start = stepper.state();
  run_to(stepper, 0.5);
  const double a = radians(45);
  return slip(stepper, start, 45) - kGravity / 2 * (std::sin(a) - std::cos(a) * std::tan(radians(40))) * 0.25;
}

}  // namespace

// Steady sliding of an elastic block is unstable at high friction (eigenvalues: standard_body.cpp). The stiffness
// damping of the strain modes, on by default, prevents it at steps that resolve the flutter too.
TEST(StandardSlide, strain_damping_keeps_a_block_from_fluttering_at_small_steps) {
  EXPECT_LE(std::abs(flutter_error(1e-4, StrainDamping::critical)), 1e-10);
  EXPECT_GE(std::abs(flutter_error(1e-4, StrainDamping::none)), 1e-6);
}

// Sudden gravity makes the contact oscillate, which friction turns into slip: 2e-3 m are physics, not solver.
TEST(StandardSlide, a_suddenly_loaded_block_slides_within_two_millimetres) {
  for (const Choice& choice : kChoices) {
    for (double dt : {1e-3, 1e-2}) {
      for (const auto& [slope, friction] : kSliding) {
        Scene scene = slope_scene(slope, friction, dt, choice);
        scene.settings.standard.start = StartRule::sudden;
        StandardStepper stepper(scene);
        const State start = stepper.state();
        run_to(stepper, 1);
        const double a = radians(slope);
        const double expected = kGravity / 2 * (std::sin(a) - std::cos(a) * std::tan(radians(friction)));
        EXPECT_NEAR(slip(stepper, start, slope), expected, 2e-3)
            << name_of(choice) << ", dt " << dt << ", slope " << slope << ", friction " << friction;
      }
    }
  }
}

// dda-05: s = v0²/(2 a), a = g (cos a tan phi - sin a). The instant of the stop is known to about a step of time: the
// distance error is at most a (dt)²/2, and the block stays at rest afterwards.
TEST(StandardSlide, a_block_faster_than_friction_allows_stops_where_it_should_and_stays) {
  struct Case {
    double slope, friction, speed;
  };
  for (const Choice& choice : kChoices) {
    for (const auto& [slope, friction, speed] : {Case{15, 30, 3}, Case{0, 16.699244233993621, 5}}) {
      for (double dt : {1e-3, 1e-2}) {
        const Scene scene = slope_scene(slope, friction, dt, choice, speed);
        StandardStepper stepper(scene);
        const State start = stepper.state();
        const double a = radians(slope);
        const double deceleration = kGravity * (std::cos(a) * std::tan(radians(friction)) - std::sin(a));
        run_to(stepper, speed / deceleration + 0.1);
        const double expected = speed * speed / (2 * deceleration);
        const double error = slip(stepper, start, slope) - expected;
        const double rest = length(velocity(stepper));
        EXPECT_LE(std::abs(error), deceleration * dt * dt) << name_of(choice) << ", slope " << slope << ", dt " << dt;
        EXPECT_LE(rest, 1e-3) << name_of(choice) << ", slope " << slope << ", dt " << dt;
      }
    }
  }
}

// The upper side of one base is rough to the left and smooth to the right of a vertex in its middle.
TEST(StandardSlide, each_part_of_a_straight_side_has_its_own_friction) {
  const double slope = radians(30);
  Blocks blocks = block_on_slope(slope);
  BlockLoop& base = blocks.blocks[0].outer;
  ASSERT_EQ(base.size(), 4U);
  base.insert(base.begin() + 3, BlockVertex{turned(Point{10, 0}, -slope), 0});
  base[4].joint_material = 1;
  blocks.blocks.push_back(support::turned_rectangle({12, 0}, {13, 1}, -slope));
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.joint_materials = {JointMaterial{}, JointMaterial{}};
  analysis.joint_materials[1].friction_angle_deg = 40;
  const Scene scene = standard_scene_of(blocks, analysis, standard_settings(analysis));
  StandardStepper stepper(scene);
  const State start = stepper.state();
  run_to(stepper, 0.5);
  EXPECT_NEAR(length(support::travel(stepper, start, 1)), 0, 1e-6);
  EXPECT_NEAR(length(support::travel(stepper, start, 2)), 9.81 * std::sin(slope) / 2 * 0.25, 1e-6);
}

}  // namespace keyblock::standard_slide_test
