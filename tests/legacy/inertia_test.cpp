// The velocity that a step starts with.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/inertia.hpp"

#include <gtest/gtest.h>

#include "tests/legacy/one_block.hpp"

namespace keyblock::inertia_test {
namespace {

using support::kBlock;
using support::legacy_scene;
using support::plain_analysis;
using support::system_of_one_block;

}  // namespace

// Shi 1988: K += 2 M / dt², F += 2/dt M k v0; static runs (k = 0) keep the first and lose the second.
TEST(Inertia, carries_the_velocity_over_by_its_share) {
  for (double carry_over : {0.0, 0.5, 1.0}) {
    ShiScene scene = legacy_scene(kBlock, plain_analysis(1e-3, 1));
    scene.settings.velocity_carry_over = carry_over;
    State state = start(scene).state;
    state.elements[ElementIndex{0}].velocity[1] = -3;
    System system = system_of_one_block();
    add_inertia({scene.model, state, scene.settings, 0.1}, system);
    EXPECT_NEAR(system.load[1], 2 / 0.1 * 5000 * carry_over * -3, 1e-9);
    EXPECT_NEAR(system.matrix.row(0)[0].block(1, 1), 2 * 5000 / 0.01, 1e-8);
  }
}

}  // namespace keyblock::inertia_test
