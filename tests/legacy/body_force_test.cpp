// Weight of the current area, with one gravity for all or the own unit weight of each material.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/body_force.hpp"

#include <gtest/gtest.h>

#include "tests/support/scenes.hpp"

namespace keyblock::body_force_test {
namespace {

using support::legacy_scene;
using support::plain_analysis;
using support::rectangle;

/// Two blocks of area 2 and 3; the second of a material with its own density and unit weight.
ShiScene two_materials() {
  BlockPolygon second = rectangle({20, 0}, {23, 1});
  second.material = 1;
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.block_materials.push_back(analysis.block_materials[0]);
  analysis.block_materials[1].density = 1000;
  analysis.block_materials[1].unit_weight = 7;
  return legacy_scene({{rectangle({0, 0}, {2, 1}), second}, {}, {}, {}, {}, {}}, analysis);
}

Eigen::VectorXd load_of(const ShiScene& scene) {
  const State state = start(scene).state;
  System system({6, 6});
  add_body_force({scene.model, state, scene.settings, 1e-3}, system);
  return system.load;
}

}  // namespace

// Legacy-rules 7.3: F_v -= rho g S with one g for all; unit weights have no effect.
TEST(BodyForce, is_density_times_the_one_gravity_under_the_quirk) {
  const Eigen::VectorXd load = load_of(two_materials());
  EXPECT_NEAR(load[1], -2500 * 9.81 * 2, 1e-9);
  EXPECT_NEAR(load[7], -1000 * 9.81 * 3, 1e-9);
}

TEST(BodyForce, is_the_own_unit_weight_of_each_material_without_the_quirk) {
  ShiScene scene = two_materials();
  scene.settings.quirks.weight_of_first_material = false;
  const Eigen::VectorXd load = load_of(scene);
  EXPECT_NEAR(load[1], -24525 * 2, 1e-9);
  EXPECT_NEAR(load[7], -7 * 3, 1e-12);
}

TEST(BodyForce, acts_at_the_centroid_and_turns_nothing) {
  const Eigen::VectorXd load = load_of(two_materials());
  EXPECT_EQ(load[0], 0);
  EXPECT_EQ(load.segment<4>(2).norm(), 0);
}

}  // namespace keyblock::body_force_test
