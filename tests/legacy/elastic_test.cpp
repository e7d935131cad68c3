// Elastic stiffness of a rectangle in plane stress and plane strain.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/elastic.hpp"

#include <gtest/gtest.h>

#include "tests/legacy/one_block.hpp"

namespace keyblock::terms_elastic_test {
namespace {

using support::kBlock;
using support::legacy_scene;
using support::plain_analysis;
using support::system_of_one_block;

}  // namespace

// Area × E/(1-nu²) [1 nu 0; nu 1 0; 0 0 (1-nu)/2] on the strains, nothing on the rigid motions.
TEST(Elastic, plane_stress_stiffness_is_the_area_times_the_modulus) {
  const ShiScene scene = legacy_scene(kBlock, plain_analysis(1e-3, 1));
  const State state = start(scene).state;
  System system = system_of_one_block();
  add_elastic({scene.model, state, scene.settings, 1e-3}, system);
  const auto& k = system.matrix.row(0)[0].block;
  const double direct = 2 * 5e9 / (1 - 0.0625);
  EXPECT_NEAR(k(3, 3) / direct, 1, 1e-14);
  EXPECT_NEAR(k(4, 4) / direct, 1, 1e-14);
  EXPECT_NEAR(k(3, 4) / (0.25 * direct), 1, 1e-14);
  EXPECT_NEAR(k(5, 5) / (0.375 * direct), 1, 1e-14);
  EXPECT_EQ(k.topRows(3).norm(), 0);
}

// The Berkeley plane-strain stiffness is stiffer by (1+nu)/(1-nu) than the right one (legacy-rules 7.2).
TEST(Elastic, plane_strain_quirk_is_a_factor) {
  ShiScene scene = legacy_scene(kBlock, plain_analysis(1e-3, 1));
  scene.settings.plane = Plane::strain;
  const State state = start(scene).state;
  System with = system_of_one_block();
  add_elastic({scene.model, state, scene.settings, 1e-3}, with);
  scene.settings.quirks.plane_strain_factor = false;
  System without = system_of_one_block();
  add_elastic({scene.model, state, scene.settings, 1e-3}, without);
  const double right = 2 * 5e9 / 1.25 * 0.75 / 0.5;  // area × E/(1+nu) × (1-nu)/(1-2nu)
  EXPECT_NEAR(without.matrix.row(0)[0].block(3, 3) / right, 1, 1e-14);
  EXPECT_NEAR(with.matrix.row(0)[0].block(3, 3) / right, 1.25 / 0.75, 1e-14);
}

}  // namespace keyblock::terms_elastic_test
