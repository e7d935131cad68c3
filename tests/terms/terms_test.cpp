// Each term against its closed form on a rectangle.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "terms/assemble.hpp"
#include "terms/elastic.hpp"
#include "terms/fixed_point.hpp"
#include "terms/inertia.hpp"
#include "terms/point_load.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock {
namespace {

using testing::legacy_scene;
using testing::plain_analysis;
using testing::rectangle;

const Blocks kBlock{{rectangle({10, 20}, {12, 21})}, {}, {}, {}, {}, {}};

System system_of_one_block() {
  return System({6});
}

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

// The Berkeley plane-strain stiffness is stiffer by (1+nu)/(1-nu) than the right one (legacy-rules 7.2).
TEST(Elastic, plane_strain_quirk_is_a_factor) {
  Scene scene = legacy_scene(kBlock, plain_analysis(1e-3, 1));
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

TEST(PointLoad, acts_at_the_point_with_the_value_at_the_end_of_the_step) {
  Blocks blocks = kBlock;
  blocks.loading_points = {{{12, 20.5}, 0, {}}};
  Analysis analysis = plain_analysis(0.5, 1);
  analysis.point_loads = {{{0, 1}, {{0, 0}, {0, 8}}, {}}};
  const Scene scene = legacy_scene(blocks, analysis);
  const State state = start(scene).state;
  System system = system_of_one_block();
  add_point_load({scene.model, state, scene.settings, 0.5}, system);
  EXPECT_NEAR(system.load[1], 4, 1e-12);      // half of 8
  EXPECT_NEAR(system.load[2], 4 * 1, 1e-12);  // lever 1 about the centroid
}

TEST(FixedPoint, pulls_back_what_has_drifted_and_follows_a_given_motion) {
  Blocks blocks = kBlock;
  blocks.fixed_points = {{{11, 20.5}, 0, {}}};
  const Scene scene = legacy_scene(blocks, plain_analysis(1e-3, 1));
  State state = start(scene).state;
  state.fixed_points[0].displacement = {0.25, 0};
  System system = system_of_one_block();
  add_fixed_point({scene.model, state, scene.settings, 1e-3}, system);
  EXPECT_DOUBLE_EQ(system.load[0], -0.25 * 100 * 5e9);
  EXPECT_DOUBLE_EQ(system.matrix.row(0)[0].block(0, 0), 100 * 5e9);
}

// A term that the scene does not need is not in the list that is called.
TEST(Assemble, only_required_terms_are_called) {
  EXPECT_EQ(legacy_scene(kBlock, plain_analysis(1e-3, 1)).terms.size(), 4U);
  Analysis weightless = plain_analysis(1e-3, 1);
  weightless.gravity = 0;
  EXPECT_EQ(legacy_scene(kBlock, weightless).terms.size(), 3U);
}

}  // namespace keyblock
