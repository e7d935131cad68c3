// The first state has the stress and velocity of the material, by the slots of the Berkeley program or by the file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/step/start_state.hpp"

#include <gtest/gtest.h>

#include "tests/support/scenes.hpp"

namespace keyblock::start_state_test {

using support::plain_analysis;
using support::rectangle;

// Berkeley slots 8-10 (legacy-rules 7.5, 16.1): DDAML Ivelocity is velocity and stress gradient both.
TEST(StartState, ddaml_start_velocity_is_also_a_stress_gradient_under_the_quirk) {
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.block_materials[0].initial_velocity = {1, 0, 2};
  const Model model = model_from_blocks({{rectangle({0, 2}, {2, 4})}, {}, {}, {}, {}, {}}, analysis);
  Settings settings = profile_settings("legacy", analysis);
  const State with = start_state(model, settings);
  EXPECT_EQ(with.elements[ElementIndex{0}].stress, (Stress{3, 0, 6}));
  settings.quirks.start_velocity_slots = false;
  const State without = start_state(model, settings);
  EXPECT_EQ(without.elements[ElementIndex{0}].stress, (Stress{0, 0, 0}));
  EXPECT_EQ(without.elements[ElementIndex{0}].velocity[0], 1);
}

TEST(StartState, native_stress_gradient_and_velocity_are_apart_without_the_quirk) {
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.dialect = AnalysisDialect::berkeley;
  analysis.block_materials[0].initial_stress = {10, 20, 0};
  analysis.block_materials[0].stress_gradient = {1, 2, 0};
  analysis.block_materials[0].initial_velocity = {0, 5, 0};
  const Model model = model_from_blocks({{rectangle({0, 2}, {2, 4})}, {}, {}, {}, {}, {}}, analysis);
  Settings settings = profile_settings("legacy", analysis);
  settings.quirks.start_velocity_slots = false;
  const State state = start_state(model, settings);
  EXPECT_EQ(state.elements[ElementIndex{0}].stress, (Stress{13, 26, 0}));
  EXPECT_EQ(state.elements[ElementIndex{0}].velocity[1], 5);
}

}  // namespace keyblock::start_state_test
