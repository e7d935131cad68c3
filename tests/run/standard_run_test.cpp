// Profile `standard` through the run loop: frames, reports, refusals.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "run/prepare.hpp"
#include "run/run.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::standard_run_test {
namespace {

using support::plain_analysis;
using support::rectangle;

Problem block_on_floor() {
  Blocks blocks;
  blocks.blocks = {rectangle({-2, -1}, {3, 0}), rectangle({0, 0}, {1, 1})};
  blocks.fixed_points = {{{-1, -0.5}, 0, {}}, {{2, -0.5}, 0, {}}};
  Problem problem;
  problem.geometry = blocks;
  problem.analysis = plain_analysis(1e-3, 10);
  return problem;
}

std::vector<double> heights(const Prepared& prepared) {
  std::vector<double> all;
  Observer observer;
  observer.on_frame = [&](const Frame& frame) { all.push_back(frame.elements[1].centroid.y); };
  EXPECT_EQ(run(prepared.scene, 1, observer).end, RunEnd::finished);
  return all;
}

}  // namespace

TEST(StandardRun, a_held_floor_costs_no_unknowns_and_the_block_three_or_six) {
  EXPECT_EQ(prepare(block_on_floor(), "standard", {}).requirements.unknowns, 6);
  EXPECT_EQ(prepare(block_on_floor(), "standard", {{"basis", "rigid"}}).requirements.unknowns, 3);
}

TEST(StandardRun, displacement_is_counted_from_the_unloaded_blocks_and_runs_repeat_to_the_bit) {
  const Prepared prepared = prepare(block_on_floor(), "standard", {});
  const std::vector<double> first = heights(prepared);
  EXPECT_EQ(first.size(), 11U);
  EXPECT_NEAR(first.front(), 0.5 - 12262.5 / 2 / 5e9, 1e-12);
  EXPECT_EQ(first, heights(prepared));
}

TEST(StandardRun, steps_report_their_touches_and_that_both_are_closed) {
  Observer observer;
  observer.on_step = [](const StepReport& report) {
    EXPECT_EQ(report.contacts, 2);
    EXPECT_EQ(report.closed, 2);
    EXPECT_LE(report.residual, 1e-10);
  };
  run(prepare(block_on_floor(), "standard", {}).scene, 1, observer);
}

}  // namespace keyblock::standard_run_test
