// Rayleigh damping over a step, of the material's own mass and stiffness.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/damping.hpp"

#include <gtest/gtest.h>

#include "tests/legacy/one_block.hpp"

namespace keyblock::terms_damping_test {

// 2 × 1 block: mass 5000, ∫ρx² = 2500·2/3; plane stress with ν = 0, S E = 1e10.
TEST(DampingTerm, is_mass_and_stiffness_by_their_factors_over_the_step) {
  Analysis analysis = support::plain_analysis(1e-3, 1);
  analysis.block_materials[0].poissons_ratio = 0;
  ShiScene scene = support::legacy_scene(support::kBlock, analysis);
  scene.settings.mass_damping.own[0] = 3;
  scene.settings.stiffness_damping.common = 1e-4;
  System system = support::system_of_one_block();
  add_damping({scene.model, start(scene).state, scene.settings, 0.5}, system);
  const auto& c = system.matrix.row(0)[0].block;
  EXPECT_NEAR(c(0, 0), 3 * 5000 / 0.5, 1e-8);
  EXPECT_NEAR(c(3, 3), (3 * 2500 * 2.0 / 3 + 1e-4 * 1e10) / 0.5, 1e-5);
  EXPECT_EQ(system.load.norm(), 0);
}

}  // namespace keyblock::terms_damping_test
