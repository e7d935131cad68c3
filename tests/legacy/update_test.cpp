// After an accepted step everything has moved, stress has grown by the strain, and velocity follows constant
// acceleration.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/step/update.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/scenes.hpp"

namespace keyblock::update_test {
namespace {

using support::legacy_scene;
using support::plain_analysis;
using support::rectangle;

/// 2 × 1 about (11, 20.5), E = 5e9, nu = 0.25.
ShiScene one_block() {
  Blocks blocks;
  blocks.blocks = {rectangle({10, 20}, {12, 21})};
  blocks.fixed_points = {{{10, 20.5}, 0, {}}};
  blocks.loading_points = {{{12, 20.5}, 0, {}}};
  blocks.measured_points = {{{11, 21}, 0, {}}};
  return legacy_scene(blocks, plain_analysis(1e-3, 1));
}

Increments increment(std::initializer_list<double> d) {
  Increments increments(1);
  increments[ElementIndex{0}] = Unknowns::Zero(6);
  int k = 0;
  for (double value : d) increments[ElementIndex{0}][k++] = value;
  return increments;
}

State updated(const ShiScene& scene, const Increments& increments) {
  return update(scene.model, start(scene).state, scene.settings, increments, 0.1);
}

void expect_near(Point found, Point expected) {
  EXPECT_NEAR(found.x, expected.x, 1e-13);
  EXPECT_NEAR(found.y, expected.y, 1e-13);
}

}  // namespace

TEST(Update, vertices_points_and_centroid_move_together) {
  const State state = updated(one_block(), increment({0.3, -0.2}));
  expect_near(state.vertices[VertexIndex{2}], {12.3, 20.8});
  expect_near(state.elements[ElementIndex{0}].centroid, {11.3, 20.3});
  expect_near(state.fixed_points[0].position, {10.3, 20.3});
  expect_near(state.loading_points[0].position, {12.3, 20.3});
  expect_near(state.measured_points[0].displacement, {0.3, -0.2});
}

TEST(Update, displacements_of_points_add_up_over_steps) {
  const ShiScene scene = one_block();
  State state = start(scene).state;
  for (int i = 0; i < 3; ++i) state = update(scene.model, std::move(state), scene.settings, increment({0.1, 0}), 0.1);
  expect_near(state.measured_points[0].displacement, {0.3, 0});
  EXPECT_EQ(state.step, 3);
  EXPECT_NEAR(state.time, 0.3, 1e-15);
  EXPECT_EQ(state.dt, 0.1);
}

// Area and mass are not conserved: the current polygon counts (legacy-rules 7).
TEST(Update, area_and_moments_are_those_of_the_strained_polygon) {
  const State state = updated(one_block(), increment({0, 0, 0, 0.1, 0.2}));
  const ElementState& block = state.elements[ElementIndex{0}];
  EXPECT_NEAR(block.moments.area, 2.2 * 1.2, 1e-12);
  EXPECT_NEAR(block.moments.xx, 2.2 * 2.2 * 2.2 * 1.2 / 12, 1e-11);
}

TEST(Update, stress_grows_by_the_modulus_of_the_plane_times_the_strain) {
  ShiScene scene = one_block();
  const Stress plane_stress = updated(scene, increment({0, 0, 0, 1e-3, 0, 2e-3})).elements[ElementIndex{0}].stress;
  EXPECT_NEAR(plane_stress.xx, 5e6 / (1 - 0.0625), 1e-6);
  EXPECT_NEAR(plane_stress.yy, 0.25 * 5e6 / (1 - 0.0625), 1e-6);
  EXPECT_NEAR(plane_stress.xy, 2e-3 * 5e9 / 2.5, 1e-6);
  scene.settings.plane = Plane::strain;  // the right factor, for any stiffness (legacy-rules 12)
  const Stress plane_strain = updated(scene, increment({0, 0, 0, 1e-3})).elements[ElementIndex{0}].stress;
  EXPECT_NEAR(plane_strain.xx, 5e6 * 0.75 / (1.25 * 0.5), 1e-6);
  EXPECT_NEAR(plane_strain.yy, 5e6 * 0.25 / (1.25 * 0.5), 1e-6);
}

TEST(Update, rotation_turns_the_polygon_but_not_the_stress) {
  ShiScene scene = one_block();
  scene.settings.rotation = Rotation::exact;
  State state = start(scene).state;
  state.elements[ElementIndex{0}].stress = {1, 2, 3};
  state = update(scene.model, std::move(state), scene.settings, increment({0, 0, std::acos(0.0)}), 0.1);
  expect_near(state.vertices[VertexIndex{2}], {10.5, 21.5});  // (1, 0.5) from the centroid becomes (-0.5, 1)
  EXPECT_EQ(state.elements[ElementIndex{0}].stress, (Stress{1, 2, 3}));
  EXPECT_EQ(state.elements[ElementIndex{0}].rotation, std::acos(0.0));
}

// v = 2 d/dt - v0; under the quirk this waits for the size of the coming step (legacy-rules 7.4).
TEST(Update, velocity_is_set_at_once_only_without_the_quirk) {
  ShiScene scene = one_block();
  State state = start(scene).state;
  state.elements[ElementIndex{0}].velocity[0] = 3;
  const auto velocity = [&] {
    return update(scene.model, state, scene.settings, increment({0.5}), 0.1).elements[ElementIndex{0}].velocity[0];
  };
  EXPECT_EQ(velocity(), 3);
  scene.settings.quirks.velocity_from_coming_step = false;
  EXPECT_NEAR(velocity(), 7, 1e-12);
  scene.settings.velocity_carry_over = 0.5;
  EXPECT_NEAR(velocity(), 8.5, 1e-12);
}

TEST(Update, velocity_of_the_last_step_takes_the_given_step_size) {
  ShiScene scene = one_block();
  State state = updated(scene, increment({0.5}));
  state.elements[ElementIndex{0}].velocity[0] = 3;
  state = with_velocity_of_last_step(scene.model, std::move(state), scene.settings, 0.05);
  EXPECT_NEAR(state.elements[ElementIndex{0}].velocity[0], 17, 1e-12);
}

}  // namespace keyblock::update_test
