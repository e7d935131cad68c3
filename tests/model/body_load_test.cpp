// Weight under a gravity that is rotated or scaled, and the sum of constant and tabulated acceleration.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/body_load.hpp"

#include <gtest/gtest.h>

namespace keyblock::body_load_test {
namespace {

BlockMaterial rock(double density, double unit_weight) {
  BlockMaterial material;
  material.density = density;
  material.unit_weight = unit_weight;
  return material;
}

Settings settings_of(double file_gravity, Point gravity) {
  Settings settings;
  settings.quirks.weight_of_first_material = false;
  settings.file_gravity = file_gravity;
  settings.gravity = gravity;
  return settings;
}

void expect_weight(Eigen::Vector2d weight, Point expected) {
  EXPECT_NEAR(weight.x(), expected.x, 1e-12);
  EXPECT_NEAR(weight.y(), expected.y, 1e-12);
}

}  // namespace

TEST(BodyLoad, under_the_gravity_of_the_file_the_weight_is_the_unit_weight) {
  EXPECT_EQ(weight_per_area(rock(2, 20.3), settings_of(9.81, {0, -9.81})).y(), -20.3);
}

TEST(BodyLoad, unit_weights_turn_and_grow_with_gravity) {
  expect_weight(weight_per_area(rock(2, 30), settings_of(10, {5, -20})), {15, -60});
  expect_weight(weight_per_area(rock(2, 30), settings_of(10, {})), {0, 0});
}

TEST(BodyLoad, where_the_file_has_no_gravity_unit_weights_stay_and_density_weighs_on_top) {
  expect_weight(weight_per_area(rock(2, 3), settings_of(0, {})), {0, -3});
  expect_weight(weight_per_area(rock(2, 3), settings_of(0, {1, -10})), {2, -23});
}

TEST(BodyLoad, under_the_quirk_density_alone_weighs) {
  Settings settings = settings_of(9.81, {1, -10});
  settings.quirks.weight_of_first_material = true;
  expect_weight(weight_per_area(rock(2, 30), settings), {2, -20});
}

TEST(BodyLoad, constant_and_tabulated_acceleration_add_up) {
  Settings settings;
  EXPECT_FALSE(has_body_acceleration(settings));
  settings.body_acceleration.curve = {{0, 1}, {{0, 0}, {0, 0}}, {}};
  EXPECT_FALSE(has_body_acceleration(settings));
  settings.body_acceleration.curve.values[1] = {4, -2};
  EXPECT_TRUE(has_body_acceleration(settings));
  settings.body_acceleration.constant = {1, 1};
  expect_weight(body_acceleration_at(settings, 0.5), {3, 0});
}

}  // namespace keyblock::body_load_test
