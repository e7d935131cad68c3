// Step size rules, and the answer to a step that cannot be made.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/step_size.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/scenes.hpp"

namespace keyblock::step_size_test {
namespace {

using support::legacy_scene;
using support::plain_analysis;
using support::rectangle;
using support::step_once;

Blocks one_block() {
  return {{rectangle({0, 0}, {2, 2})}, {}, {}, {}, {}, {}};
}

}  // namespace

// dt = sqrt(2 g2 w0 / a) from rest under gravity (legacy-formats 3.4).
TEST(StepSize, first_automatic_step_reaches_the_allowed_displacement) {
  Analysis analysis = plain_analysis(1, 10);
  analysis.automatic_time_step = true;
  analysis.allowed_displacement_ratio = 0.01;
  const ShiScene scene = legacy_scene(one_block(), analysis);
  EXPECT_NEAR(first_step_size(scene.model, start(scene).state, scene.settings, 0), std::sqrt(2 * 0.01 / 9.81), 1e-15);
}

TEST(StepSize, without_anything_to_move_the_given_step_is_used) {
  Analysis analysis = plain_analysis(0.25, 10);
  analysis.automatic_time_step = true;
  analysis.block_materials[0].unit_weight = 0;
  const ShiScene scene = legacy_scene(one_block(), analysis);
  EXPECT_EQ(first_step_size(scene.model, start(scene).state, scene.settings, 0), 0.25);
}

// Legacy-rules 11.2: q > 3 cuts dt by sqrt(q) and, with a constant step, the cut stays.
TEST(StepSize, a_step_that_moves_too_far_is_cut_and_stays_cut) {
  Analysis analysis = plain_analysis(0.1, 10);
  analysis.allowed_displacement_ratio = 0.01;
  const ShiScene scene = legacy_scene(one_block(), analysis);
  Stepping stepping = start(scene);
  const StepReport first = step_once(scene, stepping);
  EXPECT_EQ(first.redos, 1);
  const double ratio = 9.81 * 0.1 * 0.1 / 2 / 0.01;
  EXPECT_NEAR(first.dt, 0.1 / std::sqrt(ratio), 1e-12);
  EXPECT_LE(step_once(scene, stepping).dt, first.dt);
}

TEST(StepSize, a_run_that_cannot_move_within_the_allowance_fails_and_says_so) {
  Analysis analysis = plain_analysis(1, 10);
  analysis.allowed_displacement_ratio = 1e-6;
  analysis.block_materials[0].initial_velocity = {100, 0, 0};
  const ShiScene scene = legacy_scene(one_block(), analysis);
  Stepping stepping = start(scene);
  const auto made = advance(scene, stepping);
  ASSERT_TRUE(std::holds_alternative<StepFailure>(made));
  EXPECT_NE(std::get<StepFailure>(made).reason.find("smallest step"), std::string::npos);
  EXPECT_EQ(stepping.state.step, 0);
}

TEST(StepSize, a_state_that_is_not_finite_is_a_failure) {
  Analysis analysis = plain_analysis(1e100, 1);
  analysis.allowed_displacement_ratio = 1e300;
  const ShiScene scene = legacy_scene(one_block(), analysis);
  Stepping stepping = start(scene);
  EXPECT_TRUE(std::holds_alternative<StepFailure>(advance(scene, stepping)));
  EXPECT_EQ(stepping.state.step, 0);
}

// A stiffness so great that the solution cannot balance the weight any more.
TEST(StepSize, a_solution_out_of_balance_is_a_failure) {
  Analysis analysis = plain_analysis(1e-3, 5);
  analysis.contact_penalty = 1e24;
  Blocks blocks{{rectangle({-2, -1}, {3, 0}), rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}};
  blocks.fixed_points = {{{-1.9, -0.9}, 0, {}}, {{2.9, -0.1}, 0, {}}};
  analysis.allowed_displacement_ratio = 0.01;
  const ShiScene scene = legacy_scene(blocks, analysis);
  Stepping stepping = start(scene);
  std::string reason;
  for (int i = 0; i < 5 && reason.empty(); ++i) {
    const auto made = advance(scene, stepping);
    if (const auto* failure = std::get_if<StepFailure>(&made)) reason = failure->reason;
  }
  EXPECT_NE(reason.find("out of balance"), std::string::npos) << reason;
}

}  // namespace keyblock::step_size_test
