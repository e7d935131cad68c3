// Tolerances of sets of blocks that do not touch.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/set_shares.hpp"

#include <gtest/gtest.h>

#include "step/scene/touch_search.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock {
namespace {

// Shares of a fixed floor, a block of `side` and a block of 50 m that begins at `left`.
std::vector<double> shares_beside(double side, double left, double speed = 0) {
  Analysis analysis = support::plain_analysis(1e-3, 1);
  analysis.block_materials.push_back(analysis.block_materials[0]);
  analysis.block_materials[1].initial_velocity = {speed, 0, 0};
  Blocks blocks;
  blocks.blocks = {support::rectangle({-1, -1}, {200, 0}), support::rectangle({0, 0}, {side, side}),
                   support::rectangle({left, 0}, {left + 50, 50})};
  blocks.blocks[1].material = 1;
  blocks.fixed_points = {{{0, -0.8}, 0, {}}, {{199, -0.2}, 0, {}}};
  const StandardScene scene =
      standard_scene(support::standard_scene_of(blocks, analysis, support::standard_settings(analysis)));
  const Motion start = start_motion(scene);
  const UnknownsTable loads = loads_at(scene, start.q, 0);
  const Touches touches = touches_of(scene, start, scales_of(scene, loads, start.q, start.v), 1e-3);
  return shares_of_sets(scene, start, loads, touches, 1e-3);
}

TEST(SetShares, a_set_is_judged_by_its_own_weight) {
  const std::vector<double> shares = shares_beside(0.5, 100);
  ASSERT_EQ(shares.size(), 3);
  EXPECT_EQ(shares[0], 1);  // fixed
  EXPECT_NEAR(shares[1], 1e-4, 1e-16);
  EXPECT_EQ(shares[2], 1);
}

// The tolerance of a body in flight is that of its momentum over the step: 1e-13 against 1e-10 of the weight.
TEST(SetShares, momentum_counts_as_in_a_scene_of_the_set_alone) {
  const double weight = 9.81, speed = 3;
  const double large = 50 * 50 * weight;
  const double small = 0.25 * (weight + 1e-3 * speed / 1e-3);
  EXPECT_NEAR(shares_beside(0.5, 100, speed)[1], small / (large + 0.25 * 1e-3 * speed / 1e-3), 1e-12);
}

TEST(SetShares, blocks_that_touch_or_have_similar_weights_are_judged_together) {
  EXPECT_TRUE(shares_beside(0.5, 0.5).empty());
  EXPECT_TRUE(shares_beside(20, 100).empty());
}

}  // namespace
}  // namespace keyblock
