// One rigid block on two springs: each step by the rule of a spring that was closed before, soon in equilibrium if the
// step is too long for it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "step/time/smooth_solve.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::closed_springs_test {
namespace {

using support::plain_analysis;
using support::rectangle;
using support::standard_scene_of;
using support::standard_settings;

constexpr double kGravity = 9.81;
constexpr double kMass = 2500;  // of a square metre
constexpr double kStep = 0.01;

// A square metre on a fixed floor; two springs with ω dt = `followed` together.
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

// A spring that was open has its force at the end of the step, and R = ω² dt²:
//     (1 + R/2) v1 = (1 − R/2) v0 − g dt − (R/dt) q0,   q1 = q0 + (v0 + v1) dt/2;
// one that was closed has −p (q0 + dt v1):
//     (1 + R) v1 = v0 − g dt − (R/dt) q0.
struct Rule {
  double r;
  double q = 0;
  double v = 0;
  bool closed = false;
  void step() {
    const double known = v - kGravity * kStep - r / kStep * q;
    const double next = closed ? known / (1 + r) : (known - r / 2 * v) / (1 + r / 2);
    closed = true;
    q += (v + next) * kStep / 2;
    v = next;
  }
};

}  // namespace

TEST(ClosedSprings, a_block_on_springs_moves_by_their_rule) {
  for (const double followed : {0.3, 1.0, 100.0}) {
    StandardStepper stepper(on_springs(followed));
    Rule rule{followed * followed};
    for (int i = 0; i < 30; ++i) {
      step(stepper);
      rule.step();
      ASSERT_NEAR(speed(stepper), rule.v, 1e-9 * kGravity * kStep) << followed << ", step " << i;
    }
  }
}

// The roots of the rule have the size √½ as R grows: ten steps leave a 32nd.
TEST(ClosedSprings, what_a_step_cannot_follow_comes_to_rest_on_the_compressed_springs) {
  StandardStepper stepper(on_springs(100));
  step(stepper);
  const double first = std::abs(speed(stepper));
  for (int i = 0; i < 40; ++i) step(stepper);
  EXPECT_LT(std::abs(speed(stepper)), 2e-6 * first);
  const double settled = -kMass * kGravity / (2 * stepper.scene().normal_stiffness());
  EXPECT_NEAR(stepper.motion().q[ElementIndex{1}][1], settled, 1e-5 * std::abs(settled));
  for (const auto& [touch, memory] : stepper.motion().closed.all())
    EXPECT_NEAR(memory.normal, kMass * kGravity / 2, 1e-5 * kMass * kGravity);
}

// The energy that vanishes is the loss of the algorithm; no work is created.
TEST(ClosedSprings, what_rings_down_is_in_the_ledger_as_algorithmic_loss) {
  StandardStepper stepper(on_springs(100));
  LedgerSums sums;
  sums.add(stepper.ledger());
  for (int i = 0; i < 40; ++i) {
    step(stepper);
    sums.add(stepper.ledger());
  }
  const LedgerRow end = stepper.ledger();
  const double released = -end.stored.gravity;
  EXPECT_NEAR(end.stored.contact, released / 2, 1e-3 * released);
  EXPECT_NEAR(end.flow.algorithmic + end.flow.closing, released / 2, 1e-3 * released);
  EXPECT_LE(sums.energy_closure(), 1e-9);
}

// A column that leans by half a radian falls about its corner: the normal of the floor has no effect on the motion of
// its corner.
TEST(ClosedSprings, a_block_that_turns_about_its_corner_loses_little_and_in_second_order) {
  double before = 0;
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
    const EnergyFlow& flow = end.flow;
    const double lost =
        (std::abs(flow.algorithmic) + std::abs(flow.clean_up) + std::abs(flow.closing) + std::abs(flow.geometric)) /
        end.stored.kinetic;
    EXPECT_LE(lost, 5 * dt * dt) << dt;
    if (before > 0) {
      EXPECT_NEAR(before / lost, 4, 0.4);
    }
    before = lost;
  }
}

// A floor fixed at one point and driven at another gives way to the dashpots no more than to any force.
TEST(ClosedSprings, a_block_on_a_driven_floor_moves_with_it) {
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
  support::run_to(stepper, 0.6);
  EXPECT_NEAR(speed(stepper), 0.5, 1e-6);
  EXPECT_NEAR(stepper.motion().v[ElementIndex{0}][1], 0.5, 1e-9);
}

}  // namespace keyblock::closed_springs_test
