// Steps whose size is chosen by their error or by displacement, compared with closed forms.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/controlled_step.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/support/standard_scenes.hpp"

namespace keyblock::controlled_step_test {
namespace {

using support::block_on_slope;
using support::plain_analysis;
using support::radians;
using support::rectangle;
using support::run_to;
using support::standard_scene_of;
using support::standard_settings;

constexpr double kGravity = 9.81;
constexpr std::array<StepControl, 2> kControls{StepControl::shi, StepControl::error};

Settings controlled(const Analysis& analysis, StepControl control, double tolerance = 1e-4) {
  Settings settings = standard_settings(analysis);
  settings.step_control = control;
  settings.standard.step_tolerance = tolerance;
  return settings;
}

// dda-05: distance error of a block that friction stops from 3 m/s, output once per 0.1 s.
double stopping_error(double tolerance) {
  const double a = radians(15);
  Analysis analysis = plain_analysis(0.1, 1);
  analysis.joint_materials[0].friction_angle_deg = 30;
  analysis.block_materials[0].initial_velocity = {3 * std::cos(a), -3 * std::sin(a), 0};
  const Scene scene =
      standard_scene_of(block_on_slope(a), analysis, controlled(analysis, StepControl::error, tolerance));
  StandardStepper stepper(scene);
  const State start = stepper.state();
  const double deceleration = kGravity * (std::cos(a) * std::tan(radians(30)) - std::sin(a));
  run_to(stepper, 1.5);  // it stops after 1.02 s
  return std::abs(dot(support::travel(stepper, start, 1), {std::cos(a), -std::sin(a)}) - 9 / (2 * deceleration));
}

// A rigid square dropped by 0.4905 m with e = 0.5 meets the floor at √0.1 s and is `rebound` high at the end.
double drop_error(double tolerance) {
  Blocks blocks;
  blocks.blocks = {rectangle({-2, -1}, {3, 0}), rectangle({0, 0.4905}, {1, 1.4905})};
  blocks.fixed_points = {{{-1, -0.5}, 0, {}}, {{2, -0.5}, 0, {}}};
  Analysis analysis = plain_analysis(0.1, 1);
  Settings settings = controlled(analysis, StepControl::error, tolerance);
  settings.basis = BlockBasis::rigid;
  settings.standard.restitution = 0.5;
  const Scene scene = standard_scene_of(blocks, analysis, settings);
  StandardStepper stepper(scene);
  run_to(stepper, 0.5);
  const double meets = std::sqrt(2 * 0.4905 / kGravity);
  const double after = 0.5 - meets;
  const double expected = 0.5 * kGravity * meets * after - kGravity * after * after / 2;
  return std::abs(stepper.state().elements[ElementIndex{1}].centroid.y - 0.5 - expected);
}

}  // namespace

// dda-01 and ext-06: output steps of a second, exact and ending where they should.
TEST(ControlledStep, free_fall_is_exact_and_ends_in_time) {
  for (StepControl control : kControls) {
    const Analysis analysis = plain_analysis(1, 2);
    const Scene scene =
        standard_scene_of({{rectangle({0, 10}, {1, 11})}, {}, {}, {}, {}, {}}, analysis, controlled(analysis, control));
    StandardStepper stepper(scene);
    run_to(stepper, 2);
    EXPECT_EQ(stepper.state().time, 2);
    EXPECT_NEAR((stepper.state().elements[ElementIndex{0}].centroid.y - 10.5) / -19.62, 1, 1e-10);
  }
}

// dda-03 (30, 15) at output steps of ext-06.
TEST(ControlledStep, a_sliding_block_follows_the_closed_form) {
  const double a = radians(30);
  for (StepControl control : kControls) {
    for (double dt : {0.1, 0.5, 1.0}) {
      Analysis analysis = plain_analysis(dt, 1);
      analysis.joint_materials[0].friction_angle_deg = 15;
      analysis.allowed_displacement_ratio = 0.01;
      const Scene scene = standard_scene_of(block_on_slope(a), analysis, controlled(analysis, control));
      StandardStepper stepper(scene);
      const State start = stepper.state();
      run_to(stepper, 1);
      const double expected = kGravity / 2 * (std::sin(a) - std::cos(a) * std::tan(radians(15)));
      EXPECT_NEAR(dot(support::travel(stepper, start, 1), {std::cos(a), -std::sin(a)}), expected, 1e-9) << dt;
    }
  }
}

// ext-06: a step too long for the allowed displacement is made in parts that keep to it, within the rule's lag.
TEST(ControlledStep, shi_rule_keeps_displacements_near_the_allowed_one) {
  Analysis analysis = plain_analysis(1, 1);
  analysis.allowed_displacement_ratio = 0.01;
  Settings settings = controlled(analysis, StepControl::shi);
  const Scene scene = standard_scene_of(block_on_slope(radians(30)), analysis, settings);
  StandardStepper stepper(scene);
  const auto made = stepper.advance();
  ASSERT_TRUE(std::holds_alternative<StepReport>(made));
  EXPECT_LE(std::get<StepReport>(made).displacement_ratio, 3);
  EXPECT_LT(std::get<StepReport>(made).dt, 0.2);
  settings.step_control = StepControl::constant;
  const Scene constant = standard_scene_of(block_on_slope(radians(30)), analysis, settings);
  StandardStepper whole(constant);
  EXPECT_GT(std::get<StepReport>(whole.advance()).displacement_ratio, 10);  // 2.45 m over 1 % of some 9.5 m
}

TEST(ControlledStep, error_falls_with_the_tolerance) {
  constexpr double kRoundOff = 1e-13;  // relative
  for (const auto& [name, error_of, bound] :
       {std::tuple{"stop", &stopping_error, 1.0}, std::tuple{"drop", &drop_error, 1.0}}) {
    double last = 1;
    for (double tolerance : {1e-2, 1e-3, 1e-4, 1e-5}) {
      const double error = error_of(tolerance);
      EXPECT_LE(error, bound * tolerance) << name;
      EXPECT_LE(error, std::max(last, kRoundOff)) << name;
      last = error;
      RecordProperty(fmt::format("{}, tolerance {}", name, tolerance), fmt::format("{:.1e}", error));
    }
  }
}

// A tolerance that no part of the least size meets: the step is made, with a warning.
TEST(ControlledStep, parts_that_are_cut_no_further_are_counted) {
  const double a = radians(30);
  Analysis analysis = plain_analysis(0.1, 1);
  analysis.block_materials[0].initial_velocity = {0, 0, 50};
  Settings settings = controlled(analysis, StepControl::shi);
  settings.allowed_displacement_ratio = 1e-6;
  settings.standard.least_step_share = 0.25;
  const Scene scene = standard_scene_of(block_on_slope(a), analysis, settings);
  StandardStepper stepper(scene);
  const auto made = stepper.advance();
  ASSERT_TRUE(std::holds_alternative<StepReport>(made));
  EXPECT_EQ(std::get<StepReport>(made).unresolved_parts, 4);
  EXPECT_EQ(std::get<StepReport>(made).dt, 0.025);
}

}  // namespace keyblock::controlled_step_test
