// Statics with slivers: those glued or left out carry load and weigh in proportion to their area.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/staged_runs.hpp"

namespace keyblock::slivers_run_test {
namespace {

using support::kWeight;
using support::plain_analysis;
using support::rectangle;

constexpr double kSliver = 0.005;  // its width; it is one high

/// A block of 2 × 2 on a fixed floor, with an unsupported sliver beside its upper half.
Problem wall_with_sliver(double friction_deg = 0) {
  Problem problem;
  Blocks all;
  all.blocks = {rectangle({0, 0}, {10, 1}), rectangle({4, 1}, {6, 3}), rectangle({6, 2}, {6 + kSliver, 3})};
  all.fixed_points = {{{0.5, 0.5}, 0, {}}, {{9.5, 0.5}, 0, {}}};
  problem.geometry = all;
  problem.analysis = plain_analysis(1e-3, 1);
  problem.analysis->joint_materials[0].friction_angle_deg = friction_deg;
  problem.analysis->velocity_carry_over = 0;
  return problem;
}

struct Stood {
  RunOutcome outcome;
  double vertical = 0;  ///< force of the contacts on the first block, downward
  Frame last;
};

Stood run_of(const Problem& problem, const std::string& slivers, const std::string& profile = "standard") {
  Stood stood;
  Observer observer;
  observer.on_frame = [&](const Frame& frame) { stood.last = frame; };
  observer.on_contacts = [&](const ContactFrames& contacts) {
    stood.vertical = 0;
    for (const ContactFrame& contact : contacts) {
      if (contact.element == 0) stood.vertical -= contact.force().y;
      if (contact.other == 0) stood.vertical += contact.force().y;
    }
  };
  stood.outcome = run(prepare(problem, profile, {{"slivers", slivers}}).scene, 1, observer);
  return stood;
}

std::string refusal_of(const Problem& problem, const std::string& slivers) {
  try {
    prepare(problem, "standard", {{"slivers", slivers}});
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST(SliversRun, statics_of_a_wall_fails_for_a_sliver_that_is_kept_alone) {
  const Problem problem = wall_with_sliver();
  const Stood kept = run_of(problem, "keep");
  EXPECT_EQ(kept.outcome.end, RunEnd::failed);
  EXPECT_EQ(kept.outcome.numbers, std::vector<int>{3});

  const Stood glued = run_of(problem, "glue");
  EXPECT_EQ(glued.outcome.reason, "");
  EXPECT_EQ(glued.last.elements.size(), 2U);
  EXPECT_NEAR(glued.vertical, kWeight * (4 + kSliver), 1e-6 * kWeight);

  const Stood left_out = run_of(problem, "leave_out");
  EXPECT_EQ(left_out.outcome.reason, "");
  EXPECT_NEAR(left_out.vertical, kWeight * 4, 1e-6 * kWeight);
}

TEST(SliversRun, the_old_rules_step_with_glued_slivers_and_keep_them_unasked) {
  const Stood glued = run_of(wall_with_sliver(), "glue", "legacy");
  EXPECT_EQ(glued.outcome.reason, "");
  EXPECT_EQ(glued.last.elements.size(), 2U);
  EXPECT_EQ(prepare(wall_with_sliver(), "legacy", {}).scene.model.elements.size(), 3U);
}

TEST(SliversRun, stages_begin_with_the_rock_as_it_was_glued) {
  Problem problem = wall_with_sliver(30);
  problem.analysis->velocity_carry_over = 1;
  problem.stages = {support::stage_of(2), support::stage_of(2)};
  problem.stages[1].excavations = {{support::box({5, 2}, {7, 4}), 0, {}}};
  const support::Told told = support::told_of(problem, {{"slivers", "glue"}});
  EXPECT_NEAR(told.frames.front().elements[1].area, 4 + kSliver, 1e-4);
  EXPECT_NEAR(told.frames.back().elements[1].area, 3, 1e-4);  // less the quarter with the sliver

  problem.stages[1].settings = {{"slivers", "leave_out"}};
  EXPECT_EQ(refusal_of(problem, "glue"), "");  // reported for all stages
  problem.stages[0].settings = {{"slivers", "glue"}};
  try {
    prepare(problem, "standard", {});
    ADD_FAILURE() << "the second stage asks for other slivers";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("expected the setting slivers of the first stage"), std::string::npos);
  }
}

TEST(SliversRun, rock_that_is_all_on_covers_refuses_them) {
  Problem problem = wall_with_sliver();
  CoverPlan plan;
  plan.mesh.side = 0.9;
  plan.place = {"case.json", 3, 2};
  problem.covers = plan;
  EXPECT_EQ(refusal_of(problem, "glue"),
            "case.json:3:2: error: expected slivers=keep if all bodies are NMM bodies, found glue");
  problem.covers->mesh.materials = {{0}};
  EXPECT_EQ(refusal_of(problem, "glue"), "");
}

}  // namespace keyblock::slivers_run_test
