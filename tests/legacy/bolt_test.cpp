// Bolts pull with their present force, resist elongation, and carry the blocks attached to them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/bolt.hpp"

#include <gtest/gtest.h>

#include "tests/legacy/one_block.hpp"

namespace keyblock::bolt_test {
namespace {

using support::kBlock;
using support::legacy_scene;
using support::plain_analysis;
using support::rectangle;
using support::step_once;
using support::system_of_one_block;

/// 2 × 1 about (11, 20.5) and about (15, 20.5), far apart, with one bolt from corner to corner.
Blocks two_blocks(double stiffness, double pretension) {
  Blocks blocks{{rectangle({10, 20}, {12, 21}), rectangle({14, 20}, {16, 21})}, {}, {}, {}, {}, {}};
  blocks.bolts = {{{{12, 21}, {14, 21}}, 0, 1, stiffness, 0, pretension}};
  return blocks;
}

/// 2 × 1 with 4 m of room below a fixed one; two bolts of `stiffness` above its quarter points.
Blocks hanging_block(double stiffness) {
  Blocks blocks{{rectangle({0, 5}, {2, 6}), rectangle({0, 0}, {2, 1})}, {}, {}, {}, {}, {}};
  blocks.fixed_points = {{{0.1, 5.5}, 0, {}}, {{1.9, 5.5}, 0, {}}};
  blocks.bolts = {{{{0.5, 5.5}, {0.5, 0.5}}, 0, 1, stiffness, 0, 0}, {{{1.5, 0.5}, {1.5, 5.5}}, 1, 0, stiffness, 0, 0}};
  return blocks;
}

}  // namespace

TEST(Bolt, pulls_its_ends_together_with_its_force) {
  const ShiScene scene = legacy_scene(two_blocks(100, 7), plain_analysis(1e-3, 1));
  System system({6, 6});
  add_bolt({scene.model, start(scene).state, scene.settings, 1e-3}, system);
  EXPECT_DOUBLE_EQ(system.load[0], 7);
  EXPECT_NEAR(system.load[2], -7 * 0.5, 1e-12);  // line of force half a block above the centroid
  EXPECT_DOUBLE_EQ(system.load[6], -7);
  EXPECT_NEAR(system.load[8], 7 * 0.5, 1e-12);
  EXPECT_EQ(system.load[1], 0);
}

TEST(Bolt, resists_that_its_ends_part_and_no_other_motion) {
  const ShiScene scene = legacy_scene(two_blocks(100, 0), plain_analysis(1e-3, 1));
  System system({6, 6});
  add_bolt({scene.model, start(scene).state, scene.settings, 1e-3}, system);
  Eigen::VectorXd apart = Eigen::VectorXd::Zero(12);
  apart[6] = 0.5;
  EXPECT_DOUBLE_EQ((system.matrix * apart)[6], 50);
  EXPECT_DOUBLE_EQ((system.matrix * apart)[0], -50);
  Eigen::VectorXd together = Eigen::VectorXd::Zero(12);
  together[0] = together[6] = 3;
  together[7] = 2;  // across
  EXPECT_EQ((system.matrix * together).norm(), 0);
}

TEST(Bolt, within_one_block_resists_its_stretching) {
  Blocks blocks = kBlock;
  blocks.bolts = {{{{10.5, 20.5}, {11.5, 20.5}}, 0, 0, 100, 0, 7}};
  const ShiScene scene = legacy_scene(blocks, plain_analysis(1e-3, 1));
  System system = system_of_one_block();
  add_bolt({scene.model, start(scene).state, scene.settings, 1e-3}, system);
  Eigen::VectorXd stretch = Eigen::VectorXd::Zero(6);
  stretch[3] = 0.01;  // lengthens the metre of bolt by 0.01
  EXPECT_NEAR((system.matrix * stretch)[3], 100 * 0.01, 1e-12);
  EXPECT_NEAR(system.load[3], -7, 1e-12);
}

// Closed form: each hangs with W/2 on a spring of k, in either order of the ends.
TEST(Bolt, two_bolts_share_the_weight_that_hangs_on_them) {
  constexpr double kStiffness = 1e6;
  Analysis analysis = plain_analysis(1, 10);
  analysis.velocity_carry_over = 0;
  const ShiScene scene = legacy_scene(hanging_block(kStiffness), analysis);
  Stepping stepping = start(scene);
  for (int i = 0; i < 10; ++i) step_once(scene, stepping);
  const double weight = 2500 * 9.81 * 2;
  for (const BoltState& bolt : stepping.state.bolts) {
    // Density times the present area is the mass; strains here are below 2e-5.
    EXPECT_NEAR(bolt.force, weight / 2, 2e-5 * weight);
    EXPECT_NEAR(distance(bolt.first, bolt.second) - 5, weight / (2 * kStiffness), 2e-5 * weight / kStiffness);
  }
}

// Closed form: without stiffness the pre-tension is a constant force, f t²/(2m) on either side.
TEST(Bolt, pretension_pulls_two_free_blocks_together) {
  constexpr double kForce = 1e4;
  constexpr double kMass = 5000;
  Blocks blocks = two_blocks(0, kForce);
  blocks.bolts[0].segment = {{11.5, 20.5}, {14.5, 20.5}};  // through both centroids: no rotation
  Analysis analysis = plain_analysis(1e-2, 50);
  analysis.gravity = 0;
  analysis.allowed_displacement_ratio = 0.01;  // and with it the reach within which contacts are searched
  const ShiScene scene = legacy_scene(blocks, analysis);
  Stepping stepping = start(scene);
  for (int i = 0; i < 50; ++i) step_once(scene, stepping);
  const double moved = kForce / kMass * 0.5 * 0.5 / 2;
  const double left = stepping.state.elements[ElementIndex{0}].centroid.x - 11;
  const double right = stepping.state.elements[ElementIndex{1}].centroid.x - 15;
  EXPECT_NEAR(left, moved, 1e-5 * moved);  // mass by the present area, strains below 1e-5
  EXPECT_NEAR(left + right, 0, 1e-12);     // momentum stays zero
  EXPECT_DOUBLE_EQ(stepping.state.bolts[0].force, kForce);
}

}  // namespace keyblock::bolt_test
