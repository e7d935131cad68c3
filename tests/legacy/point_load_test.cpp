// A load in time at its point.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/point_load.hpp"

#include <gtest/gtest.h>

#include "tests/legacy/one_block.hpp"

namespace keyblock::point_load_test {
namespace {

using support::kBlock;
using support::legacy_scene;
using support::plain_analysis;
using support::system_of_one_block;

}  // namespace

TEST(PointLoad, acts_at_the_point_with_the_value_at_the_end_of_the_step) {
  Blocks blocks = kBlock;
  blocks.loading_points = {{{12, 20.5}, 0, {}}};
  Analysis analysis = plain_analysis(0.5, 1);
  analysis.point_loads = {{{0, 1}, {{0, 0}, {0, 8}}, {}}};
  const ShiScene scene = legacy_scene(blocks, analysis);
  const State state = start(scene).state;
  System system = system_of_one_block();
  add_point_load({scene.model, state, scene.settings, 0.5}, system);
  EXPECT_NEAR(system.load[1], 4, 1e-12);      // half of 8
  EXPECT_NEAR(system.load[2], 4 * 1, 1e-12);  // lever 1 about the centroid
}

}  // namespace keyblock::point_load_test
