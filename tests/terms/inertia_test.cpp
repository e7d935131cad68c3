// The mass matrix against its closed form on a rectangle, and the velocity that a step starts with.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms/inertia.hpp"

#include <gtest/gtest.h>

#include "tests/terms/one_block.hpp"

namespace keyblock::inertia_test {
namespace {

using support::kBlock;
using support::legacy_scene;
using support::plain_analysis;
using support::system_of_one_block;

}  // namespace

// ∫ρ TᵀT over b × h about its centre: mass rho b h, rotary inertia m (b² + h²)/12, strain inertia m b²/12 and so on.
TEST(Inertia, mass_matrix_of_a_rectangle) {
  const Scene scene = legacy_scene(kBlock, plain_analysis(1e-3, 1));
  const State state = start(scene).state;
  const UnknownBlock mass = mass_matrix(affine_basis(), state.elements[ElementIndex{0}].moments, 2500);
  const double m = 2500 * 2;
  EXPECT_NEAR(mass(0, 0), m, 1e-8);
  EXPECT_NEAR(mass(2, 2), m * (4 + 1) / 12, 1e-7);
  EXPECT_NEAR(mass(3, 3), m * 4 / 12, 1e-7);
  EXPECT_NEAR(mass(4, 4), m * 1 / 12, 1e-7);
  EXPECT_NEAR(mass(5, 5), m * (4 + 1) / 48, 1e-7);
  EXPECT_NEAR(mass(2, 5), m * (4 - 1) / 24, 1e-7);
  EXPECT_NEAR(mass(0, 2), 0, 1e-8);
}

// Shi 1988: K += 2 M / dt², F += 2/dt M k v0; static runs (k = 0) keep the first and lose the second.
TEST(Inertia, carries_the_velocity_over_by_its_share) {
  for (double carry_over : {0.0, 0.5, 1.0}) {
    Scene scene = legacy_scene(kBlock, plain_analysis(1e-3, 1));
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
