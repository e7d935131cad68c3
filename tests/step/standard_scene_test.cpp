// Unknowns of Dynamics::standard: those of the blocks that move, and no others.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/standard_scene.hpp"

#include <gtest/gtest.h>

#include "run/prepare.hpp"
#include "step/standard_stepper.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::standard_scene_test {
namespace {

using support::plain_analysis;
using support::rectangle;

// A fixed floor and three squares on it, without friction.
Problem three_squares() {
  Blocks blocks;
  blocks.blocks = {rectangle({-2, -1}, {6, 0}), rectangle({0, 0}, {1, 1}), rectangle({2, 0}, {3, 1}),
                   rectangle({2, 1}, {3, 2})};
  blocks.fixed_points = {{{-1, -0.5}, 0, {}}, {{5, -0.5}, 0, {}}};
  Problem problem;
  problem.geometry = blocks;
  problem.analysis = plain_analysis(1e-3, 3);
  return problem;
}

}  // namespace

TEST(StandardScene, a_rigid_scene_without_friction_solves_three_unknowns_a_moving_block_and_none_for_a_held_one) {
  const Prepared prepared = prepare(three_squares(), "standard", {{"basis", "rigid"}});
  EXPECT_EQ(prepared.requirements.unknowns, 9);
  StandardStepper stepper(prepared.scene);
  ASSERT_TRUE(std::holds_alternative<StepReport>(stepper.advance()));
  for (ElementIndex e : indices(stepper.scene().bodies())) {
    const Eigen::Index expected = e.value == 0 ? 0 : 3;
    EXPECT_EQ(stepper.scene().bodies()[e].mass.rows(), expected);
    EXPECT_EQ(stepper.motion().q[e].size(), expected);
  }
}

}  // namespace keyblock::standard_scene_test
