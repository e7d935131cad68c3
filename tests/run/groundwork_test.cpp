// Steppers use the cached data of the scene, or compute it themselves, with the same result to the bit.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/polygon.hpp"
#include "model/continuum.hpp"
#include "run/growth/parents.hpp"
#include "run/prepare.hpp"
#include "run/stages/chain.hpp"
#include "step/standard_stepper.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock {
namespace {

constexpr double kTriangle = 0.2;

/// A plate of 1 by 2 that flies and rotates, with an edge crack as far as `end`.
Scene flying_plate(double end) {
  Problem problem;
  Blocks blocks;
  blocks.blocks = {support::rectangle({0, -1}, {1, 1})};
  problem.geometry = blocks;
  problem.analysis = support::plain_analysis(1e-4, 1);
  problem.analysis->velocity_carry_over = 1;
  problem.analysis->block_materials[0].initial_velocity = {1, -0.5, 0.8};
  problem.covers.emplace();
  problem.covers->mesh.side = kTriangle;
  problem.covers->mesh.angle_deg = 10;
  problem.covers->cracks = {{{{0, 0}, {end, 0.01}}, {}}};
  return prepare(problem, "standard", {}).scene;
}

Scene without_groundwork(Scene scene) {
  scene.groundwork = nullptr;
  return scene;
}

SceneChange change_to(const StandardStepper& before, Scene after) {
  int number = static_cast<int>(before.model().elements.size());
  const Table<ElementIndex, ElementIndex> parents = parents_by_place(before.model(), after.model);
  return change_between(before.model(), std::move(after), parents, number);
}

void expect_same_bits(const StandardStepper& one, const StandardStepper& other) {
  EXPECT_TRUE(std::ranges::equal(one.state().vertices, other.state().vertices));
  EXPECT_EQ(one.on_covers()->d, other.on_covers()->d);
  EXPECT_EQ(*one.on_covers()->acceleration, *other.on_covers()->acceleration);
}

TEST(Groundwork, changes_no_bit_of_the_steps_before_and_after_a_crack_grows) {
  const Scene first = flying_plate(0.4);
  const Scene next = flying_plate(0.45);
  ASSERT_TRUE(first.groundwork);
  StandardStepper with(first), without(without_groundwork(first));
  for (StandardStepper* stepper : {&with, &without}) stepper->advance();
  expect_same_bits(with, without);
  StandardStepper grown(with, change_to(with, next));
  StandardStepper grown_without(without, change_to(without, without_groundwork(next)));
  expect_same_bits(grown, grown_without);
  for (StandardStepper* stepper : {&grown, &grown_without}) stepper->advance();
  expect_same_bits(grown, grown_without);
}

TEST(Groundwork, serves_two_steppers_that_step_in_turns) {
  const Scene scene = flying_plate(0.4);
  StandardStepper one(scene), other(scene), alone(without_groundwork(scene));
  for (int i = 0; i < 2; ++i) one.advance();
  other.advance();
  alone.advance();
  expect_same_bits(other, alone);
  one.advance();
  for (StandardStepper* stepper : {&other, &alone}) stepper->advance();
  expect_same_bits(other, alone);
}

TEST(Groundwork, of_another_scene_is_not_taken) {
  Scene scene = flying_plate(0.4);
  scene.groundwork = flying_plate(0.6).groundwork;
  StandardStepper misled(scene), alone(without_groundwork(scene));
  for (StandardStepper* stepper : {&misled, &alone}) stepper->advance();
  expect_same_bits(misled, alone);
}

TEST(ParentsByPlace, are_the_elements_that_hold_a_point_of_the_new_ones_inside) {
  const Scene before = flying_plate(0.4);
  const Scene after = flying_plate(0.75);
  const Manifold& was = before.model.continuum->manifold;
  const Manifold& is = after.model.continuum->manifold;
  ASSERT_LT(was.elements.size(), is.elements.size());
  const Table<ElementIndex, ElementIndex> parents = parents_by_place(before.model, after.model);
  for (ElementIndex e : indices(parents)) {
    const auto loops = is.polygon(is.elements[static_cast<std::size_t>(e.value)]);
    const auto of_parent = was.polygon(was.elements[static_cast<std::size_t>(parents[e].value)]);
    const std::optional<Point> inside = point_inside(loops);
    ASSERT_TRUE(inside);
    EXPECT_EQ(side(of_parent.front(), *inside), Side::inside) << "element " << e.value;
  }
}

}  // namespace
}  // namespace keyblock
