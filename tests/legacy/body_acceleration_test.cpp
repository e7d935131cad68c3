// A given acceleration loads the centroid of every element with its mass, at the end of the step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/body_acceleration.hpp"

#include <gtest/gtest.h>

#include "tests/legacy/one_block.hpp"

namespace keyblock::terms_body_acceleration_test {

TEST(BodyAcceleration, is_mass_times_the_acceleration_at_the_end_of_the_step) {
  ShiScene scene = support::legacy_scene(support::kBlock, support::plain_analysis(1e-3, 1));
  scene.settings.body_acceleration.curve = {{0, 0.5}, {{0, 0}, {3, -1}}, {}};
  System system = support::system_of_one_block();
  add_body_acceleration({scene.model, start(scene).state, scene.settings, 0.25}, system);
  EXPECT_NEAR(system.load[0], 2500 * 2 * 1.5, 1e-9);
  EXPECT_NEAR(system.load[1], 2500 * 2 * -0.5, 1e-9);
  EXPECT_EQ(system.load.tail<4>().norm(), 0);
}

}  // namespace keyblock::terms_body_acceleration_test
