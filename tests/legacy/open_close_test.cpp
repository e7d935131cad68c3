// Number of solves of the iteration: the first solve of a run twice, contacts that never settle up to the bound.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/step/open_close.hpp"

#include <gtest/gtest.h>

#include "tests/support/scenes.hpp"

namespace keyblock::open_close_test {
namespace {

using support::legacy_scene;
using support::plain_analysis;
using support::rectangle;

/// A block on another. `settles` false: closing within w0 of distance and opening above minus w0, so that every check
/// reverses every contact.
ShiScene two_blocks(bool settles, int pass_limit = 8) {
  Analysis analysis = plain_analysis(1e-3, 1);
  analysis.allowed_displacement_ratio = 0.01;
  analysis.open_close_limit = pass_limit;
  if (!settles) analysis.open_close.closing_ratio = analysis.open_close.opening_ratio = -1;
  ShiScene scene =
      legacy_scene({{rectangle({-2, -1}, {3, 0}), rectangle({0, 0}, {1, 1})}, {}, {}, {}, {}, {}}, analysis);
  scene.settings.redo_limit = 3;
  return scene;
}

Contact corner_on_top() {
  Contact contact;
  contact.first = {{4}, {3}, {2}};
  contact.ratio = 0.4;
  return contact;
}

OpenCloseOutcome iterated(const ShiScene& scene, Attempt attempt, Contacts contacts = {corner_on_top()}) {
  const State state = start(scene).state;
  const System system = assemble(scene.terms, {scene.model, state, scene.settings, scene.settings.time_step});
  Solver solver;
  return open_close(system, std::move(contacts), scene.model, state, scene.settings, scene.rules,
                    scene.settings.contact_penalty, scene.settings.time_step, attempt, solver);
}

}  // namespace

TEST(OpenClose, the_first_solve_of_a_run_is_repeated_though_nothing_changed) {
  EXPECT_EQ(iterated(two_blocks(true), Attempt::first_of_run).passes, 2);
  EXPECT_EQ(iterated(two_blocks(true), Attempt::first_of_step).passes, 1);
  EXPECT_EQ(iterated(two_blocks(true), Attempt::redone).passes, 1);
  EXPECT_EQ(iterated(two_blocks(true), Attempt::first_of_run, {}).passes, 2);
}

TEST(OpenClose, contacts_that_never_settle_are_given_up_after_eight_passes) {
  const OpenCloseOutcome outcome = iterated(two_blocks(false), Attempt::first_of_step);
  EXPECT_EQ(outcome.passes, 8);
  EXPECT_EQ(outcome.failure.form, "");
  EXPECT_EQ(outcome.still_changing, (std::vector<std::size_t>{0}));
}

TEST(OpenClose, another_limit_changes_the_bound_only_without_the_quirk) {
  ShiScene scene = two_blocks(false, 5);
  EXPECT_EQ(iterated(scene, Attempt::first_of_step).passes, 8);
  scene.settings.quirks.fixed_pass_bound = false;
  EXPECT_EQ(iterated(scene, Attempt::first_of_step).passes, 5);
}

TEST(OpenClose, a_step_unfinished_at_the_bound_is_redone_until_the_run_is_given_up) {
  const ShiScene scene = two_blocks(false);
  Stepping stepping = start(scene);
  const auto made = advance(scene, stepping);
  ASSERT_TRUE(std::holds_alternative<StepFailure>(made));
  EXPECT_NE(std::get<StepFailure>(made).reason.find("contacts open and close without end: 1 (block "),
            std::string::npos)
      << std::get<StepFailure>(made).reason;
  EXPECT_NE(std::get<StepFailure>(made).reason.find("Shi's programs repeat such a step without end"),
            std::string::npos);
  EXPECT_EQ(std::get<StepFailure>(made).contacts, (std::vector<std::size_t>{0, 1}));
}

// Legacy-rules 11.1: the Berkeley program compares the iterations with the given limit but ends its loop at 8.
TEST(OpenClose, under_another_limit_than_eight_an_unfinished_step_is_accepted) {
  for (int limit : {5, 9}) {
    const ShiScene scene = two_blocks(false, limit);
    Stepping stepping = start(scene);
    const StepReport report = support::step_once(scene, stepping);
    EXPECT_EQ(report.passes, 8) << limit;
    EXPECT_EQ(report.unsettled_contacts, 2) << limit;
    EXPECT_EQ(report.redos, 0) << limit;
  }
}

// Legacy-rules 9: friction of the transferred values acts in the first iteration of a step, not in that of a redo.
TEST(OpenClose, friction_of_the_last_step_acts_in_the_first_pass_unless_the_step_is_redone) {
  ShiScene scene = two_blocks(true);
  scene.model.joint_materials[0].friction_angle_deg = 45;
  Contact sliding = corner_on_top();
  sliding.state = ContactState::sliding;
  sliding.distance = -1e-6;
  sliding.penalty = scene.settings.contact_penalty;
  sliding.slip = 1;
  const auto push = [&](Attempt attempt) { return iterated(scene, attempt, {sliding}).increments[ElementIndex{1}][0]; };
  EXPECT_EQ(iterated(scene, Attempt::first_of_step, {sliding}).passes, 1);
  EXPECT_LT(push(Attempt::first_of_step), push(Attempt::redone) - 1e-9) << "5000 N to the left on 2500 kg for 1 ms";
}

TEST(OpenClose, a_system_that_cannot_be_solved_is_said_so) {
  const ShiScene scene = two_blocks(true);
  Solver solver;
  const OpenCloseOutcome outcome = open_close(System({6, 6}), {}, scene.model, start(scene).state, scene.settings,
                                              scene.rules, 1, 1, Attempt::first_of_step, solver);
  EXPECT_EQ(outcome.failure.form, "system_not_solved");
}

}  // namespace keyblock::open_close_test
