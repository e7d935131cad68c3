// One rigid block on two springs: followed as the trapezoidal rule says, at rest at once where the step is too long for them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/stiff_springs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/standard_scenes.hpp"

namespace keyblock::stiff_springs_test {
namespace {

using support::plain_analysis;
using support::rectangle;
using support::standard_scene_of;
using support::standard_settings;

constexpr double kGravity = 9.81;
constexpr double kMass = 2500;  // of a square metre
constexpr double kStep = 0.01;

// A square metre on a floor that is held; two springs with ω dt = `followed` together.
Scene on_springs(double followed, ImpactLaw impact = ImpactLaw::jump) {
  Blocks blocks;
  blocks.blocks = {rectangle({-2, -1}, {3, 0}), rectangle({0, 0}, {1, 1})};
  blocks.fixed_points = {{{-1, -0.5}, 0, {}}, {{2, -0.5}, 0, {}}};
  const Analysis analysis = plain_analysis(kStep, 1);
  Settings settings = standard_settings(analysis);
  settings.basis = BlockBasis::rigid;
  settings.standard.enforcement = Enforcement::penalty;
  settings.standard.start = StartRule::sudden;
  settings.standard.impact = impact;
  settings.contact_penalty = followed * followed * kMass / (2 * kStep * kStep);
  settings.ledger = Bookkeeping::on;
  return standard_scene_of(blocks, analysis, settings);
}

double speed(const StandardStepper& stepper) {
  return stepper.motion().v[ElementIndex{1}][1];
}

void step(StandardStepper& stepper) {
  const auto made = stepper.advance();
  if (const auto* failure = std::get_if<StepFailure>(&made)) FAIL() << failure->reason;
}

// The trapezoidal rule with the springs' force at the end of the step, R = ω² dt²:
//     (1 + R/2) v1 = (1 − R/2) v0 − g dt − (R/dt) q0,   q1 = q0 + (v0 + v1) dt/2.
struct Rule {
  double r;
  double q = 0;
  double v = 0;
  void step() {
    const double next = ((1 - r / 2) * v - kGravity * kStep - r / kStep * q) / (1 + r / 2);
    q += (v + next) * kStep / 2;
    v = next;
  }
};

}  // namespace

TEST(StiffSprings, what_the_step_follows_goes_on) {
  StandardStepper stepper(on_springs(1));
  Rule rule{1};
  for (int i = 0; i < 50; ++i) {
    step(stepper);
    rule.step();
    ASSERT_NEAR(speed(stepper), rule.v, 1e-9 * kGravity * kStep) << i;
  }
}

TEST(StiffSprings, what_it_cannot_follow_comes_to_rest_on_the_compressed_springs) {
  constexpr double kFollowed = 100;
  StandardStepper stepper(on_springs(kFollowed));
  Rule rule{kFollowed * kFollowed};
  step(stepper);
  rule.step();
  EXPECT_NEAR(speed(stepper), rule.v, 1e-9 * kGravity * kStep);  // it grows from rest: half of it is the mean
  const double first = std::abs(rule.v);
  step(stepper);
  EXPECT_LT(std::abs(speed(stepper)), 1e-3 * first);  // 1 / (1 + C/m), C = p dt² of two springs
  for (int i = 0; i < 3; ++i) step(stepper);
  EXPECT_LT(std::abs(speed(stepper)), 1e-6 * first);
  // The rule alone would keep it: (1 − R/2)/(1 + R/2) is nearly −1.
  for (int i = 0; i < 4; ++i) rule.step();
  EXPECT_GT(std::abs(rule.v), 0.9 * first);
  const double settled = -kMass * kGravity / (2 * stepper.scene().normal_stiffness());
  EXPECT_NEAR(stepper.motion().q[ElementIndex{1}][1], settled, 1e-6 * std::abs(settled));
  for (const auto& [touch, memory] : stepper.motion().closed.all())
    EXPECT_NEAR(memory.normal, kMass * kGravity / 2, 1e-6 * kMass * kGravity);
}

// The second step of the rule turns over what the first one gave: m v²/2 of it is taken.
TEST(StiffSprings, what_is_taken_is_in_the_books_as_clean_up) {
  StandardStepper stepper(on_springs(100));
  Rule rule{100 * 100};
  LedgerSums sums;
  sums.add(stepper.ledger());
  for (int i = 0; i < 6; ++i) {
    step(stepper);
    sums.add(stepper.ledger());
    if (i < 2) rule.step();
  }
  const double turned_over = kMass * rule.v * rule.v / 2;
  EXPECT_NEAR(stepper.ledger().flow.clean_up, turned_over, 1e-2 * turned_over);
  EXPECT_LE(sums.energy_closure(), 1e-9);
}

// A column that leans by half a radian falls about its corner: the normal of the floor has no part in what its corner does, though seen along
// the normal of half a step ago the rate of the corner changes sign in every step.
TEST(StiffSprings, a_block_that_turns_about_its_corner_loses_nothing) {
  for (const double dt : {1e-2, 5e-3}) {
    Blocks blocks;
    blocks.blocks = {rectangle({-5, -1}, {10, 0}), support::turned_rectangle({-1, 0}, {0, 4}, -0.5)};
    blocks.fixed_points = {{{-4, -0.5}, 0, {}}, {{9, -0.5}, 0, {}}};
    Analysis analysis = plain_analysis(dt, 1);
    analysis.joint_materials[0].friction_angle_deg = 60;
    Settings settings = standard_settings(analysis);
    settings.basis = BlockBasis::rigid;
    settings.standard.enforcement = Enforcement::penalty;
    settings.contact_penalty = 1e3 * 4 * kMass / (dt * dt);
    settings.ledger = Bookkeeping::on;
    StandardStepper stepper(standard_scene_of(blocks, analysis, settings));
    support::run_to(stepper, 0.4);
    const LedgerRow end = stepper.ledger();
    ASSERT_GT(end.stored.kinetic, 1000);
    EXPECT_LE(std::abs(end.flow.clean_up), 1e-5 * end.stored.kinetic) << dt;
  }
}

// A floor that one point holds and another drives gives way to the dashpots no more than it would to any force.
TEST(StiffSprings, a_block_on_a_driven_floor_moves_with_it) {
  Blocks blocks;
  blocks.blocks = {rectangle({-2, -1}, {3, 0}), rectangle({0, 0}, {1, 1})};
  blocks.fixed_points = {{{-1, -0.5}, 0, {}}, {{2, -0.5}, 0, {}}};
  Analysis analysis = plain_analysis(kStep, 1);
  analysis.fixed_point_motions = {{{0, 1}, {{0, 0}, {0, 0.5}}, {}}, {{0, 1}, {{0, 0}, {0, 0.5}}, {}}};
  Settings settings = standard_settings(analysis);
  settings.basis = BlockBasis::rigid;
  settings.standard.enforcement = Enforcement::penalty;
  settings.contact_penalty = 1e4 * kMass / (2 * kStep * kStep);
  StandardStepper stepper(standard_scene_of(blocks, analysis, settings));
  support::run_to(stepper, 0.2);
  EXPECT_NEAR(speed(stepper), 0.5, 1e-6);
  EXPECT_NEAR(stepper.motion().v[ElementIndex{0}][1], 0.5, 1e-9);
}

TEST(StiffSprings, springs_that_are_to_throw_back_are_left_as_they_are) {
  StandardStepper jump(on_springs(100));
  StandardStepper springs(on_springs(100, ImpactLaw::springs));
  for (int i = 0; i < 3; ++i) {
    step(jump);
    step(springs);
  }
  EXPECT_GT(std::abs(speed(springs)), 100 * std::abs(speed(jump)));
}

}  // namespace keyblock::stiff_springs_test
