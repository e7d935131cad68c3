// A block that oscillates on a bolt in profile `standard`: effect of the step on elastic energy.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/ledger_runs.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::bolt_oscillator_test {
namespace {

using support::ledger_of;
using support::plain_analysis;
using support::rectangle;
using support::standard_scene_of;
using support::standard_settings;

constexpr double kStiffness = 1e6;
constexpr double kMass = 2500;
constexpr double kSpeed = 0.3;

// A free block of a square metre on a bolt to a fixed one, pushed along it.
Scene oscillator(double dt, double force_weight) {
  Blocks blocks;
  blocks.blocks = {rectangle({-4, 0}, {-3, 1}), rectangle({0, 0}, {1, 1})};
  blocks.blocks[1].material = 1;
  blocks.fixed_points = {{{-3.9, 0.1}, 0, {}}, {{-3.1, 0.9}, 0, {}}};
  blocks.bolts = {{{{-3, 0.5}, {0, 0.5}}, 0, 1, kStiffness, 0, 0}};
  Analysis analysis = plain_analysis(dt, 1);
  analysis.gravity = 0;
  analysis.block_materials[0].unit_weight = 0;
  analysis.block_materials.push_back(analysis.block_materials[0]);
  analysis.block_materials[1].initial_velocity = {kSpeed, 0, 0};
  Settings settings = standard_settings(analysis);
  settings.standard.force_weight = force_weight;
  return standard_scene_of(blocks, analysis, settings);
}

// Fraction of the first amplitude, v0/ω by closed form, that is left in the last of five periods; ω dt = 0.2 at 10 ms.
double amplitude_left(double dt, double force_weight) {
  const double omega = std::sqrt(kStiffness / kMass);
  const double period = 2 * std::numbers::pi / omega;
  const Ledger ledger = ledger_of(oscillator(dt, force_weight), 5 * period);
  double most = 0;
  for (const LedgerRow& row : ledger.rows)
    if (row.time > 4 * period) most = std::max(most, row.stored.contact);
  return std::sqrt(2 * most / kStiffness) / (kSpeed / omega);
}

TEST(BoltOscillator, keeps_its_amplitude_under_the_default_rule) {
  EXPECT_NEAR(amplitude_left(1e-2, StandardChoices{}.force_weight), 1, 0.01);
  EXPECT_NEAR(amplitude_left(1e-3, StandardChoices{}.force_weight), 1, 0.001);
}

// Each step leaves the fraction 1/√(1 + (ω dt)²/2) of the amplitude (the rule of weights 1/2 and 1, by its
// determinant).
TEST(BoltOscillator, is_damped_by_the_weight_of_the_elastic_force) {
  const double steps = 4.5 * 2 * std::numbers::pi / 0.2;
  EXPECT_NEAR(amplitude_left(1e-2, 1), std::pow(1 + 0.2 * 0.2 / 2, -steps / 2), 0.06);
}

}  // namespace
}  // namespace keyblock::bolt_oscillator_test
