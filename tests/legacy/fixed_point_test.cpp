// Springs of the fixed points.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/fixed_point.hpp"

#include <gtest/gtest.h>

#include "tests/legacy/one_block.hpp"

namespace keyblock::fixed_point_test {
namespace {

using support::kBlock;
using support::legacy_scene;
using support::plain_analysis;
using support::system_of_one_block;

}  // namespace

TEST(FixedPoint, pulls_back_what_has_drifted) {
  Blocks blocks = kBlock;
  blocks.fixed_points = {{{11, 20.5}, 0, {}}};
  const ShiScene scene = legacy_scene(blocks, plain_analysis(1e-3, 1));
  State state = start(scene).state;
  state.fixed_points[0].displacement = {0.25, 0};
  System system = system_of_one_block();
  add_fixed_point({scene.model, state, scene.settings, 1e-3}, system);
  EXPECT_DOUBLE_EQ(system.load[0], -0.25 * 100 * 5e9);
  EXPECT_DOUBLE_EQ(system.matrix.row(0)[0].block(0, 0), 100 * 5e9);
}

TEST(FixedPoint, is_driven_along_its_motion_at_the_end_of_the_step) {
  Blocks blocks = kBlock;
  blocks.fixed_points = {{{12, 20.5}, 0, {}}};
  Analysis analysis = plain_analysis(0.5, 1);
  analysis.fixed_point_motions = {{{0, 1}, {{0, 0}, {0, 8}}, {}}};
  const ShiScene scene = legacy_scene(blocks, analysis);
  State state = start(scene).state;
  state.fixed_points[0].displacement = {0, 1};
  System system = system_of_one_block();
  add_fixed_point({scene.model, state, scene.settings, 0.5}, system);
  EXPECT_DOUBLE_EQ(system.load[1], (4 - 1) * 100 * 5e9);
  EXPECT_NEAR(system.load[2] / ((4 - 1) * 100 * 5e9), 1, 1e-12);  // lever 1 about the centroid
}

}  // namespace keyblock::fixed_point_test
