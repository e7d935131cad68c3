// Rings of blocks in contact are found, and decide between multipliers and springs if the settings request neither.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/enforcement.hpp"

#include <gtest/gtest.h>

#include "tests/support/standard_scenes.hpp"

namespace keyblock::enforcement_test {
namespace {

using support::plain_analysis;
using support::rectangle;

/// A fixed floor, two storeys of blocks side by side on it, and a lone block above.
Model wall(int columns, int storeys) {
  Blocks blocks;
  blocks.blocks = {rectangle({-1, -1}, {9, 0}), rectangle({0, 20}, {1, 21})};
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < storeys; ++j)
      blocks.blocks.push_back(rectangle({1.0 * i, 1.0 * j}, {1.0 * i + 1, 1.0 * j + 1}));
  blocks.fixed_points = {{{0, -0.5}, 0, {}}, {{8, -0.5}, 0, {}}};
  return with_bases(model_from_blocks(blocks, plain_analysis(1e-3, 1)), BlockBasis::affine);
}

}  // namespace

TEST(Enforcement, blocks_touch_where_a_corner_lies_on_an_edge) {
  EXPECT_EQ(touching_pairs(wall(1, 3)), (std::vector<ElementPair>{{{0}, {2}}, {{2}, {3}}, {{3}, {4}}}));
  EXPECT_TRUE(touching_pairs(wall(0, 0)).empty());
}

TEST(Enforcement, a_stack_has_no_ring_and_two_columns_that_touch_have_one) {
  EXPECT_FALSE(has_ring(wall(1, 5), touching_pairs(wall(1, 5))));
  EXPECT_TRUE(has_ring(wall(2, 1), touching_pairs(wall(2, 1))));
}

// Two fixed floors side by side are one support: the block across them is in no ring.
TEST(Enforcement, held_blocks_count_as_one) {
  Blocks blocks;
  blocks.blocks = {rectangle({0, -1}, {2, 0}), rectangle({2, -1}, {4, 0}), rectangle({1, 0}, {3, 1})};
  blocks.fixed_points = {{{0.5, -0.5}, 0, {}}, {{1.5, -0.5}, 0, {}}, {{2.5, -0.5}, 1, {}}, {{3.5, -0.5}, 1, {}}};
  const Analysis analysis = plain_analysis(1e-3, 1);
  const Model model = with_bases(model_from_blocks(blocks, analysis), BlockBasis::affine);
  EXPECT_EQ(touching_pairs(model).size(), 3U);
  EXPECT_FALSE(has_ring(model, touching_pairs(model)));
}

TEST(Enforcement, automatic_is_decided_and_what_was_asked_for_stays) {
  Settings settings;
  settings.standard.enforcement = Enforcement::automatic;
  EXPECT_EQ(with_enforcement_decided(settings, wall(2, 2)).standard.enforcement.common, Enforcement::lagrange);
  EXPECT_EQ(with_enforcement_decided(settings, wall(1, 20)).standard.enforcement.common, Enforcement::lagrange);
  EXPECT_EQ(with_enforcement_decided(settings, wall(5, 4)).standard.enforcement.common, Enforcement::penalty);
  settings.standard.enforcement = Enforcement::lagrange;
  settings.standard.enforcement.own[0] = Enforcement::automatic;
  const PerMaterial<Enforcement> decided = with_enforcement_decided(settings, wall(5, 4)).standard.enforcement;
  EXPECT_EQ(decided.common, Enforcement::lagrange);
  EXPECT_EQ(decided.of(0), Enforcement::penalty);
}

/// Two blocks side by side on a floor, every face bonded or the floor alone.
Model pair_on_floor(bool beside_each_other) {
  Blocks blocks;
  const double gap = beside_each_other ? 0 : 1;
  blocks.blocks = {rectangle({-1, -1}, {6, 0}), rectangle({0, 0}, {2, 2}), rectangle({2 + gap, 0}, {4 + gap, 2})};
  blocks.fixed_points = {{{0, -0.5}, 0, {}}, {{5, -0.5}, 0, {}}};
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.joint_materials[0].cohesion = 1e4;
  return with_bases(model_from_blocks(blocks, analysis), BlockBasis::affine);
}

// The corner at which three bonded blocks meet is held twice: the forces there are not determined without springs.
TEST(Enforcement, bonds_at_more_points_than_blocks_can_follow_decide_for_springs) {
  Settings settings;
  settings.standard.enforcement = Enforcement::automatic;
  EXPECT_EQ(with_enforcement_decided(settings, pair_on_floor(true)).standard.enforcement.common, Enforcement::penalty);
  EXPECT_EQ(with_enforcement_decided(settings, pair_on_floor(false)).standard.enforcement.common,
            Enforcement::lagrange);
  EXPECT_NE(why_enforcement(pair_on_floor(true), settings).find("bonds"), std::string::npos);
}

// A wall of two courses on a floor: each block touches more points than it has unknowns. Friction holds it as bonds do.
TEST(Enforcement, in_statics_friction_at_more_points_than_blocks_can_follow_decides_for_springs) {
  Settings settings;
  settings.standard.enforcement = Enforcement::automatic;
  const auto decided = [&](MotionRule motion, double friction_deg) {
    settings.standard.motion = motion;
    Model rough = wall(2, 2);
    for (JointMaterial& joint : rough.joint_materials) joint.friction_angle_deg = friction_deg;
    return with_enforcement_decided(settings, rough).standard.enforcement.common;
  };
  EXPECT_EQ(decided(MotionRule::equilibrium, 30), Enforcement::penalty);
  EXPECT_EQ(decided(MotionRule::equilibrium, 0), Enforcement::lagrange);
  EXPECT_EQ(decided(MotionRule::dynamic, 30), Enforcement::lagrange);
}

// Multipliers have no spring that could stop a block.
TEST(Enforcement, springs_that_stop_impacts_decide_for_springs) {
  Settings settings;
  settings.standard.impact = ImpactLaw::springs;
  EXPECT_EQ(with_enforcement_decided(settings, wall(2, 2)).standard.enforcement.common, Enforcement::penalty);
  EXPECT_EQ(why_enforcement(wall(2, 2), settings), "springs stop blocks that meet");
}

TEST(Enforcement, the_reason_of_the_decision_is_said) {
  EXPECT_EQ(why_enforcement(wall(2, 2), {}), "at most 8 blocks can move");
  EXPECT_EQ(why_enforcement(wall(1, 20), {}), "no blocks in contact form a ring");
  EXPECT_EQ(why_enforcement(wall(5, 4), {}), "blocks in contact form a ring");
}

}  // namespace keyblock::enforcement_test
