// Blocks that rebound in a vee with friction: several contacts are hit together, and no energy comes from nothing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/time/impulse_energy.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/ledger_sums.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::impulse_energy_test {
namespace {

using support::plain_analysis;
using support::rectangle;
using support::standard_scene_of;
using support::standard_settings;

// Three blocks above one another over a vee of 90 degrees; `shift`: of the lowest one to the side.
Blocks over_a_vee(double shift) {
  Blocks blocks;
  blocks.blocks = {{0, {{{-4, 4}, 0}, {{-4, -1}, 0}, {{0, -1}, 0}, {{0, 0}, 0}}, {}},
                   {0, {{{0, 0}, 0}, {{0, -1}, 0}, {{4, -1}, 0}, {{4, 4}, 0}}, {}},
                   rectangle({shift - 0.3, 0.6}, {shift + 0.3, 1}),
                   rectangle({-0.2, 1.1}, {0.2, 1.8}),
                   rectangle({-0.35, 1.9}, {0.35, 2.3})};
  for (const double side : {-1.0, 1.0})
    for (const double x : {0.5, 3.5}) blocks.fixed_points.push_back({{side * x, -0.5}, side < 0 ? 0 : 1, {}});
  return blocks;
}

// Newton's law of restitution alone gave these blocks up to a fifth of their energy.
TEST(ImpulseEnergy, blocks_that_rebound_in_a_vee_with_friction_gain_none) {
  for (const double restitution : {1.0, 0.8})
    for (const double shift : {-0.15, 0.0, 0.1}) {
      Analysis analysis = plain_analysis(2.5e-3, 1);
      analysis.joint_materials[0].friction_angle_deg = 20;
      Settings settings = standard_settings(analysis);
      settings.standard.restitution = restitution;
      settings.ledger = Bookkeeping::on;
      StandardStepper stepper(standard_scene_of(over_a_vee(shift), analysis, settings));
      LedgerSums sums;
      sums.add(stepper.ledger());
      for (int i = 0; i < 300; ++i) {
        ASSERT_TRUE(std::holds_alternative<StepReport>(stepper.advance())) << i;
        sums.add(stepper.ledger());
      }
      const std::string scene = fmt::format("restitution {}, shift {}", restitution, shift);
      EXPECT_LT(sums.made, 0.01 * sums.largest_stored) << scene;  // energy_limit
      EXPECT_LT(sums.energy_closure(), 1e-10) << scene;
    }
}

}  // namespace
}  // namespace keyblock::impulse_energy_test
