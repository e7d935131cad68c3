// Values recorded of a state: loops with holes apart, displacements since the start, end velocities, followed points.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/record.hpp"

#include <gtest/gtest.h>

#include "tests/support/scenes.hpp"

namespace keyblock::record_test {
namespace {

using support::legacy_scene;
using support::plain_analysis;
using support::rectangle;

Blocks frame_and_block() {
  BlockPolygon frame = rectangle({0, 0}, {4, 4});
  frame.holes = {{{{1, 1}, 0}, {{1, 3}, 0}, {{3, 3}, 0}, {{3, 1}, 0}}};
  return {{frame, rectangle({10, 0}, {12, 1})}, {}, {}, {}, {}, {}};
}

/// The second block has moved by (0.5, -0.25) in one step of 0.1 from rest.
State moved(const State& first) {
  State state = first;
  ElementState& block = state.elements[ElementIndex{1}];
  block.centroid = {11.5, 0.25};
  block.last_step = Unknowns::Zero(6);
  block.last_step.head<3>() << 0.5, -0.25, 0.125;
  block.rotation = 0.125;
  block.stress = {1, 2, 3};
  state.step = 1;
  state.time = state.dt = 0.1;
  return state;
}

}  // namespace

TEST(Record, loops_of_a_frame_are_the_outer_one_and_then_the_holes) {
  const ShiScene scene = legacy_scene(frame_and_block(), plain_analysis(1e-3, 1));
  const State first = start(scene).state;
  const Frame frame = frame_of(scene.model, first, places_of(first), scene.settings);
  ASSERT_EQ(frame.elements.size(), 2U);
  ASSERT_EQ(frame.elements[0].loops.size(), 2U);
  EXPECT_EQ(frame.elements[0].loops[0], (std::vector<Point>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  EXPECT_EQ(frame.elements[0].loops[1], (std::vector<Point>{{1, 1}, {1, 3}, {3, 3}, {3, 1}}));
  EXPECT_DOUBLE_EQ(frame.elements[0].area, 12);
  EXPECT_EQ(frame.elements[1].loops.size(), 1U);
}

TEST(Record, a_frame_counts_displacement_from_the_start_and_shows_the_end_velocity) {
  const ShiScene scene = legacy_scene(frame_and_block(), plain_analysis(1e-3, 1));
  const State first = start(scene).state;
  const Frame frame = frame_of(scene.model, moved(first), places_of(first), scene.settings);
  EXPECT_EQ(frame.step, 1);
  EXPECT_EQ(frame.time, 0.1);
  EXPECT_EQ(frame.elements[0].displacement, (Point{0, 0}));
  const ElementFrame& block = frame.elements[1];
  EXPECT_EQ(block.centroid, (Point{11.5, 0.25}));
  EXPECT_NEAR(block.displacement.x, 0.5, 1e-13);
  EXPECT_NEAR(block.displacement.y, -0.25, 1e-13);
  EXPECT_EQ(block.rotation, 0.125);
  EXPECT_EQ(block.stress, (Stress{1, 2, 3}));
  EXPECT_EQ(block.velocity, (Velocity{10, -5, 2.5}));  // 2 d/dt from rest
}

// A rectangle a x b of density ρ has the mass ρ a b and the moment of inertia ρ a b (a² + b²)/12 about its centroid.
TEST(Record, mass_and_moment_of_inertia_are_those_of_the_start) {
  const ShiScene scene = legacy_scene(frame_and_block(), plain_analysis(1e-3, 1));
  const State first = start(scene).state;
  const Frame frame = frame_of(scene.model, moved(first), places_of(first), scene.settings);
  const double density = scene.model.block_materials[0].density;
  EXPECT_NEAR(frame.elements[1].mass, density * 2, 1e-12 * density);
  EXPECT_NEAR(frame.elements[1].moment_of_inertia, density * 2 * 5 / 12, 1e-11 * density);
}

TEST(Record, followed_are_the_measured_points_with_the_number_of_their_element) {
  Blocks blocks = frame_and_block();
  blocks.measured_points = {{{11, 1}, 1, {}}};
  blocks.fixed_points = {{{0.5, 0.5}, 0, {}}};
  const ShiScene scene = legacy_scene(blocks, plain_analysis(1e-3, 1));
  const State first = start(scene).state;
  State state = moved(first);
  state.measured_points[0] = {{11.5, 0.75}, {0.5, -0.25}};
  const HistoryRow row = history_row(scene.model, state, places_of(first), true);
  EXPECT_EQ(row.step, 1);
  ASSERT_EQ(row.points.size(), 1U);
  EXPECT_EQ(row.points[0].position, (Point{11.5, 0.75}));
  EXPECT_EQ(row.points[0].displacement, (Point{0.5, -0.25}));
  EXPECT_EQ(row.points[0].element, 1);
  const Frame frame = frame_of(scene.model, state, places_of(first), scene.settings);
  ASSERT_EQ(frame.fixed_points.size(), 1U);
  EXPECT_EQ(frame.fixed_points[0].position, (Point{0.5, 0.5}));
  EXPECT_TRUE(frame.loading_points.empty());
}

TEST(Record, without_measured_points_the_centroid_of_every_element_is_followed) {
  const ShiScene scene = legacy_scene(frame_and_block(), plain_analysis(1e-3, 1));
  const State first = start(scene).state;
  const HistoryRow row = history_row(scene.model, moved(first), places_of(first), false);
  ASSERT_EQ(row.points.size(), 2U);
  EXPECT_EQ(row.points[1].position, (Point{11.5, 0.25}));
  EXPECT_NEAR(row.points[1].displacement.y, -0.25, 1e-13);
  EXPECT_EQ(row.points[1].element, 1);
}

}  // namespace keyblock::record_test
