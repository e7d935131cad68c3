// Spinning stretches blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/ledger_runs.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::spin_test {
namespace {

using support::plain_analysis;
using support::rectangle;
using support::run_to;
using support::standard_scene_of;
using support::standard_settings;

// A free bar 0.8 x 0.3 m that rotates at 100 rad/s, from any start. The mean stresses in its own axes are ρ ω² L²/12
// and ρ ω² h²/12, by the first moment of the centrifugal force. The spin continues.
TEST(Spin, stretches_a_block_by_its_centrifugal_force) {
  for (const StartRule start : {StartRule::compatible, StartRule::sudden}) {
    Blocks blocks;
    blocks.blocks = {rectangle({-0.4, -0.15}, {0.4, 0.15})};
    Analysis analysis = plain_analysis(1e-4, 1);
    analysis.gravity = 0;
    analysis.block_materials[0].unit_weight = 0;
    analysis.block_materials[0].initial_velocity = {0, 0, 100};
    Settings settings = standard_settings(analysis);
    settings.basis = BlockBasis::affine;
    settings.standard.start = start;
    StandardStepper stepper(standard_scene_of(blocks, analysis, settings));
    run_to(stepper, 0.04);
    const double density = 2500;
    const double along = density * 1e4 * 0.8 * 0.8 / 12;
    const double across = density * 1e4 * 0.3 * 0.3 / 12;
    const Stress stress = stepper.state().elements[ElementIndex{0}].stress;
    EXPECT_NEAR((stress.xx + stress.yy) / (along + across), 1, 1e-3);
    EXPECT_NEAR((stress.xx * stress.yy - stress.xy * stress.xy) / (along * across), 1, 1e-2);
    EXPECT_NEAR(stepper.motion().v[ElementIndex{0}][2], 100, 1e-9);
  }
}

}  // namespace
}  // namespace keyblock::spin_test
