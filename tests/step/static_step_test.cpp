// Static equilibria: benchmark dda-30, blocks supported by contact alone, and blocks without support.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/static_step.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

#include "step/scene/equilibrium.hpp"
#include "tests/support/cover_scenes.hpp"

namespace keyblock::static_step_test {
namespace {

using support::block_on_slope;
using support::plain_analysis;
using support::radians;
using support::rectangle;
using support::standard_scene_of;
using support::standard_settings;

constexpr double kGravity = 9.81;
struct Stack {
  int count;
  double height;  // of a block, one wide
  double modulus;
  double density;
  double penalty;
  double settlement_elastic, settlement;  // of the top, benchmark dda-30
};

constexpr std::array<Stack, 3> kStacks{{{10, 1, 1e9, 2500, 1e10, 0.00122625, 0.00129369},
                                        {10, 1, 1e9, 2500, 1e12, 0.00122625, 0.00122692},
                                        {5, 2, 5e9, 2700, 5e10, 0.00026487, 0.000272816}}};

Scene scene_of_stack(const Stack& stack, Enforcement enforcement) {
  Blocks blocks;
  blocks.blocks = {rectangle({-2, -1}, {3, 0})};
  for (int i = 0; i < stack.count; ++i)
    blocks.blocks.push_back(rectangle({0, stack.height * i}, {1, stack.height * (i + 1)}));
  blocks.fixed_points = {{{-1, -0.5}, 0, {}}, {{2, -0.5}, 0, {}}};
  blocks.measured_points = {{{0.5, stack.height * stack.count}, stack.count, {}}};
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.velocity_carry_over = 0;
  analysis.contact_penalty = stack.penalty;
  analysis.block_materials[0].poissons_ratio = 0;
  analysis.block_materials[0].youngs_modulus = stack.modulus;
  analysis.block_materials[0].density = stack.density;
  analysis.joint_materials[0].friction_angle_deg = 30;
  Settings settings = standard_settings(analysis);
  settings.standard.motion = MotionRule::equilibrium;
  settings.standard.enforcement = enforcement;
  return standard_scene_of(blocks, analysis, settings);
}

// Makes one step; returns the error, or nothing.
std::string step(StandardStepper& stepper) {
  const auto made = stepper.advance();
  const auto* failure = std::get_if<StepFailure>(&made);
  return failure == nullptr ? std::string() : failure->reason;
}

Scene slope_scene(double slope_deg, double friction_deg, BlockBasis basis, Enforcement enforcement) {
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.velocity_carry_over = 0;
  analysis.joint_materials[0].friction_angle_deg = friction_deg;
  Settings settings = standard_settings(analysis);
  settings.standard.motion = MotionRule::equilibrium;
  settings.basis = basis;
  settings.standard.enforcement = enforcement;
  return standard_scene_of(block_on_slope(radians(slope_deg)), analysis, settings);
}

}  // namespace

TEST(StaticStep, a_file_without_dynamics_is_solved_as_statics) {
  Analysis analysis = plain_analysis(1e-3, 1);
  EXPECT_EQ(standard_settings(analysis).standard.motion, MotionRule::dynamic);
  analysis.velocity_carry_over = 0;
  EXPECT_EQ(standard_settings(analysis).standard.motion, MotionRule::equilibrium);
}

// dda-30: ρ g (N h)²/(2 E) + Σ W_k/(2 p), the second part with springs alone; its table has six digits.
TEST(StaticStep, stacks_settle_as_statics_says) {
  for (Enforcement enforcement : {Enforcement::lagrange, Enforcement::penalty}) {
    for (const Stack& stack : kStacks) {
      const Scene scene = scene_of_stack(stack, enforcement);
      StandardStepper stepper(scene);
      ASSERT_EQ(step(stepper), "");
      const double found = -stepper.state().measured_points[0].displacement.y;
      const bool springs = enforcement == Enforcement::penalty;
      const double expected = springs ? stack.settlement : stack.settlement_elastic;
      EXPECT_NEAR(found / expected, 1, 5e-6) << (springs ? "springs" : "multipliers");
      RecordProperty(fmt::format("{} {}", springs ? "springs" : "multipliers", stack.penalty),
                     fmt::format("{:.7g}", found));
    }
  }
}

// Weight along and across the slope: forces of the two corners sum to W sin a and W cos a, and nothing slips.
TEST(StaticStep, a_block_held_by_friction_alone_rests) {
  for (BlockBasis basis : {BlockBasis::rigid, BlockBasis::affine}) {
    for (Enforcement enforcement : {Enforcement::lagrange, Enforcement::penalty}) {
      const Scene scene = slope_scene(20, 30, basis, enforcement);
      StandardStepper stepper(scene);
      ASSERT_EQ(step(stepper), "");
      double normal = 0;
      double tangential = 0;
      for (const auto& [touch, memory] : stepper.motion().closed.all()) {
        normal += memory.normal;
        tangential += std::abs(memory.tangential);
      }
      EXPECT_NEAR(normal / (2500 * kGravity * std::cos(radians(20))), 1, 1e-7);
      EXPECT_NEAR(tangential / (2500 * kGravity * std::sin(radians(20))), 1, 1e-7);
      // Settlement under its own weight is of the order W/E and W/p, 5e-6 m; a slip would have no bound.
      EXPECT_LE(length(support::travel(stepper, stepper.unloaded(), 1)), 2e-5);
    }
  }
}

TEST(StaticStep, a_block_that_friction_does_not_hold_is_named) {
  const Scene scene = slope_scene(30, 20, BlockBasis::affine, Enforcement::lagrange);
  StandardStepper stepper(scene);
  EXPECT_TRUE(step(stepper).starts_with("step 1 (time 0): no equilibrium: block 2 accelerates (at "));
  EXPECT_EQ(stepper.state().step, 0);
}

TEST(StaticStep, a_free_block_is_named) {
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.velocity_carry_over = 0;
  const Scene scene =
      standard_scene_of({{rectangle({0, 10}, {1, 11})}, {}, {}, {}, {}, {}}, analysis, standard_settings(analysis));
  StandardStepper stepper(scene);
  EXPECT_EQ(step(stepper),
            "step 1 (time 0): no equilibrium: block 1 accelerates (at 0.5, 10.5; area 1, 100 % of the mean)");
}

// A column falls over a toe that its weight passes outside of, and is stable inside of it: b/h against tan(slope).
TEST(StaticStep, a_column_beyond_its_limit_is_named_and_one_within_stands) {
  const double slope = radians(20);
  for (double ratio : {0.9, 1.1}) {
    Blocks blocks = block_on_slope(slope);
    const double h = 1 / (ratio * std::tan(slope));
    blocks.blocks[1] = support::turned_rectangle({8, 0}, {9, h}, -slope);
    Analysis analysis = plain_analysis(1e-3, 1);
    analysis.velocity_carry_over = 0;
    analysis.joint_materials[0].friction_angle_deg = 50;
    Settings settings = standard_settings(analysis);
    settings.standard.motion = MotionRule::equilibrium;
    const Scene scene = standard_scene_of(blocks, analysis, settings);
    StandardStepper stepper(scene);
    const std::string said = step(stepper);
    EXPECT_EQ(said.substr(0, 52), ratio > 1 ? "" : "step 1 (time 0): no equilibrium: block 2 accelerates")
        << "ratio " << ratio;
  }
}

// Elastic, sticking contact: the load path does not matter.
TEST(StaticStep, loads_put_on_in_shares_end_at_the_same_equilibrium) {
  Scene once = scene_of_stack(kStacks[0], Enforcement::lagrange);
  Scene shares = once;
  shares.settings.step_count = 4;
  shares.settings.standard.load_steps = 4;
  StandardStepper one(once);
  StandardStepper four(shares);
  ASSERT_EQ(step(one), "");
  for (int i = 1; i <= 4; ++i) {
    ASSERT_EQ(step(four), "");
    const double share = four.state().measured_points[0].displacement.y / one.state().measured_points[0].displacement.y;
    EXPECT_NEAR(share, i / 4.0, 1e-5) << i;
  }
}

// As above, but within one step, and within two: 5 equilibria are 2 and 3.
TEST(StaticStep, more_shares_than_steps_are_made_within_the_steps) {
  const Scene once = scene_of_stack(kStacks[0], Enforcement::lagrange);
  StandardStepper one(once);
  ASSERT_EQ(step(one), "");
  const auto share_of = [&](StandardStepper& stepper) {
    return stepper.state().measured_points[0].displacement.y / one.state().measured_points[0].displacement.y;
  };
  Scene whole = once;
  whole.settings.standard.load_steps = 5;
  StandardStepper in_one_step(whole);
  ASSERT_EQ(step(in_one_step), "");
  EXPECT_NEAR(share_of(in_one_step), 1, 1e-5);
  Scene halves = whole;
  halves.settings.step_count = 2;
  StandardStepper in_two_steps(halves);
  ASSERT_EQ(step(in_two_steps), "");
  EXPECT_NEAR(share_of(in_two_steps), 2.0 / 5, 1e-5);
  ASSERT_EQ(step(in_two_steps), "");
  EXPECT_NEAR(share_of(in_two_steps), 1, 1e-5);
  EXPECT_EQ(in_two_steps.ledger().step, 2);
}

// Steps after the full load cost nothing and change nothing.
TEST(StaticStep, an_equilibrium_stays_while_loads_do) {
  Scene scene = scene_of_stack(kStacks[2], Enforcement::penalty);
  scene.settings.step_count = 3;
  StandardStepper stepper(scene);
  ASSERT_EQ(step(stepper), "");
  const State first = stepper.state();
  const auto second = stepper.advance();
  ASSERT_TRUE(std::holds_alternative<StepReport>(second));
  EXPECT_EQ(std::get<StepReport>(second).passes, 0);
  EXPECT_LE(std::get<StepReport>(second).residual, 1e-8);
  for (VertexIndex v : indices(first.vertices)) EXPECT_EQ(distance(first.vertices[v], stepper.state().vertices[v]), 0);
}

// The given motion itself. A block fixed at one point above its centroid follows it upright, also without weight.
TEST(StaticStep, a_driven_point_is_followed_step_after_step) {
  for (double gravity : {kGravity, 0.0}) {
    Blocks blocks;
    blocks.blocks = {rectangle({0, 0}, {2, 1}), rectangle({5, 0}, {6, 1})};
    blocks.fixed_points = {{{1, 0.75}, 0, {}}, {{5.2, 0.5}, 1, {}}, {{5.8, 0.5}, 1, {}}};
    Analysis analysis = plain_analysis(0.1, 4);
    analysis.velocity_carry_over = 0;
    analysis.gravity = gravity;
    analysis.fixed_point_motions = {{{0, 0.2, 0.4}, {{}, {0.02, 0.01}, {0.02, -0.01}}, {}}, {}, {}};
    Settings settings = standard_settings(analysis);
    settings.standard.motion = MotionRule::equilibrium;
    settings.time_step = 0.1;
    const Scene scene = standard_scene_of(blocks, analysis, settings);
    StandardStepper stepper(scene);
    for (const Point wanted : {Point{0.01, 0.005}, Point{0.02, 0.01}, Point{0.02, 0}, Point{0.02, -0.01}}) {
      ASSERT_EQ(step(stepper), "") << "gravity " << gravity;
      const Point found = stepper.state().fixed_points[0].displacement;
      EXPECT_LE(distance(found, wanted), 1e-8) << "gravity " << gravity;
      EXPECT_NEAR(stepper.state().elements[ElementIndex{0}].rotation, 0, gravity > 0 ? 1e-6 : 1);
    }
  }
}

// Elastica of Bisshopp & Drucker 1945 at P L² / EI = 5, digits of Mattiasson 1981. The tip moves further than half the
// strip, its own size, and this is still an equilibrium, because the body is fixed. Three rows of elements, and a clamp
// of two points, have an error of 1.5 %.
TEST(StaticStep, a_held_strip_on_covers_bends_further_than_its_size) {
  const double height = 0.05;
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.velocity_carry_over = 0;
  analysis.gravity = 0;
  analysis.block_materials[0].unit_weight = 0;
  analysis.block_materials[0].poissons_ratio = 0;
  Settings settings = standard_settings(analysis);
  settings.standard.motion = MotionRule::equilibrium;
  Blocks blocks;
  blocks.blocks = {rectangle({0, 0}, {1, height})};
  Scene scene = support::mixed_scene_of(blocks, {0}, analysis, settings, 24, CoverFunctions::derived);
  const double force = -5 * analysis.block_materials[0].youngs_modulus * height * height * height / 12;
  for (VertexIndex v : indices(scene.model.vertices)) {
    const Point p = scene.model.start_vertices[static_cast<std::size_t>(v.value)];
    const ElementIndex e = scene.model.vertices[v].element;
    if (p == Point{0, 0} || p == Point{0, height}) scene.model.fixed_points.push_back({p, e, {}});
    if (p == Point{1, 0} || p == Point{1, height})
      scene.model.loading_points.push_back({p, e, {{0}, {{0, force / 2}}, {}}});
  }
  ASSERT_EQ(scene.model.loading_points.size(), 2U);
  StandardStepper stepper(scene);
  EXPECT_EQ(step(stepper), "");
  const auto& ends = stepper.state().loading_points;
  const Point tip = 0.5 * (ends[0].displacement + ends[1].displacement);
  EXPECT_NEAR(tip.y, -0.71379, 0.015);
  EXPECT_NEAR(tip.x, -0.38763, 0.015);
}

// The square of 1e155 overflows: beside it the residual must not count as zero, or the blocks would not move.
TEST(StaticStep, loads_whose_squares_overflow_are_not_taken_for_balanced) {
  Blocks blocks;
  blocks.blocks = {rectangle({0, -1}, {10, 0}), rectangle({1, 0}, {2, 1})};
  blocks.fixed_points = {{{1, -0.5}, 0, {}}, {{9, -0.5}, 0, {}}};
  for (const double weight : {1e155, 1e300}) {
    Analysis analysis = plain_analysis(1e-3, 1);
    analysis.gravity.reset();
    analysis.velocity_carry_over = 0;
    analysis.block_materials[0].unit_weight = weight;
    StandardStepper stepper(standard_scene_of(blocks, analysis, standard_settings(analysis)));
    EXPECT_TRUE(std::holds_alternative<StepFailure>(stepper.advance())) << weight;
  }
}

}  // namespace keyblock::static_step_test
