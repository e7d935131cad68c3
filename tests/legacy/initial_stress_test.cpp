// The initial stress of an element acts against its strains.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/initial_stress.hpp"

#include <gtest/gtest.h>

#include "tests/legacy/one_block.hpp"

namespace keyblock::initial_stress_test {
namespace {

using support::kBlock;
using support::legacy_scene;
using support::plain_analysis;
using support::system_of_one_block;

}  // namespace

// F -= S (sxx, syy, sxy) on (ex, ey, gxy) (legacy-rules 7.3): a pressed block (negative stress) widens.
TEST(InitialStress, is_the_area_times_the_stress_against_the_strains) {
  const ShiScene scene = legacy_scene(kBlock, plain_analysis(1e-3, 1));
  State state = start(scene).state;
  state.elements[ElementIndex{0}].stress = {-10, 20, 5};
  System system = system_of_one_block();
  add_initial_stress({scene.model, state, scene.settings, 1e-3}, system);
  const Eigen::VectorXd expected{{0, 0, 0, 20, -40, -10}};
  EXPECT_EQ(system.load, expected);
}

TEST(InitialStress, acts_on_the_current_area) {
  const ShiScene scene = legacy_scene(kBlock, plain_analysis(1e-3, 1));
  State state = start(scene).state;
  state.elements[ElementIndex{0}].stress = {1, 0, 0};
  state.elements[ElementIndex{0}].moments.area = 7;
  System system = system_of_one_block();
  add_initial_stress({scene.model, state, scene.settings, 1e-3}, system);
  EXPECT_EQ(system.load[3], -7);
}

}  // namespace keyblock::initial_stress_test
