// Places and velocities of polygons: digits far from the origin, velocity at the end of a step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/state.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/scenes.hpp"

namespace keyblock::state_test {
namespace {

/// b = 3, h = 1 at coordinates whose squares fill a double: ∫x² = b³h/12, ∫y² = bh³/12, ∫xy = 0 about the centroid.
Placement far_placement(bool moments_about_origin) {
  const Point corner{300000001, 500000003};
  const Analysis analysis = support::plain_analysis(1e-3, 1);
  const Model model =
      model_from_blocks({{support::rectangle(corner, corner + Point{3, 1})}, {}, {}, {}, {}, {}}, analysis);
  Settings settings = profile_settings("legacy", analysis);
  settings.quirks.moments_about_origin = moments_about_origin;
  Table<VertexIndex, Point> vertices;
  vertices.assign(model.start_vertices.begin(), model.start_vertices.end());
  return place(model, vertices, {0}, settings);
}

}  // namespace

TEST(State, moments_far_from_the_origin_keep_their_digits_without_the_quirk) {
  const Placement placed = far_placement(false);
  EXPECT_DOUBLE_EQ(placed.moments.area, 3);
  EXPECT_DOUBLE_EQ(placed.moments.xx, 27.0 / 12);
  EXPECT_DOUBLE_EQ(placed.moments.yy, 3.0 / 12);
  EXPECT_NEAR(placed.moments.xy, 0, 1e-15);
  EXPECT_EQ(placed.centroid, (Point{300000002.5, 500000003.5}));
}

TEST(State, moments_about_the_origin_of_coordinates_lose_them) {
  const Placement placed = far_placement(true);
  EXPECT_GT(std::abs(placed.moments.xx - 27.0 / 12) + std::abs(placed.moments.yy - 3.0 / 12), 0.1);
}

TEST(State, near_the_origin_the_quirk_changes_nothing_but_last_digits) {
  const Analysis analysis = support::plain_analysis(1e-3, 1);
  const Model model = model_from_blocks({{support::rectangle({1, 2}, {4, 3})}, {}, {}, {}, {}, {}}, analysis);
  const State state = start_state(model, profile_settings("legacy", analysis));
  EXPECT_NEAR(state.elements[ElementIndex{0}].moments.xx, 27.0 / 12, 1e-13);
  EXPECT_NEAR(state.elements[ElementIndex{0}].moments.xy, 0, 1e-13);
}

TEST(State, operators_are_taken_about_the_centroid_of_the_element) {
  const Analysis analysis = support::plain_analysis(1e-3, 1);
  const Model model = model_from_blocks({{support::rectangle({1, 2}, {4, 3})}, {}, {}, {}, {}, {}}, analysis);
  const State state = start_state(model, profile_settings("legacy", analysis));
  EXPECT_LT((basis_at(model, state, {0}, {4, 3}) - affine_basis().at({1.5, 0.5})).norm(), 1e-13);
}

// Constant acceleration from v0 over dt: d = (v0 + v) dt / 2.
TEST(State, end_velocity_makes_the_mean_velocity_that_of_the_step) {
  ElementState element;
  element.velocity = Unknowns::Constant(6, 3);     // at the start of the last step
  element.last_step = Unknowns::Constant(6, 0.5);  // mean velocity 5
  State state;
  state.dt = 0.1;
  state.step = 1;
  Settings settings;
  settings.velocity_carry_over = 1;
  EXPECT_NEAR(end_velocity(element, state, settings, 0)[0], 7, 1e-12);
  state.step = 0;
  EXPECT_EQ(end_velocity(element, state, settings, 0)[0], 3);
  state.step = 1;
  settings.quirks.velocity_from_coming_step = false;  // the state then holds the end velocity already
  EXPECT_EQ(end_velocity(element, state, settings, 0)[0], 3);
  settings.velocity_carry_over = 0;
  EXPECT_EQ(end_velocity(element, state, settings, 0)[0], 0);
}

}  // namespace keyblock::state_test
