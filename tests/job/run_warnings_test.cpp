// Warnings about the steps of a run, about its end and its bolts, from reports made by hand.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/run_warnings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "run/checkpoint.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::run_warnings_test {
namespace {

/// Two free blocks of 1 m, a gap of 1 m between them. A step of 0.01 allows a displacement of half of 1.5, which is
/// half the width of both.
Prepared two_blocks(const std::function<void(Settings&)>& change = {}) {
  Blocks blocks;
  blocks.blocks = {support::rectangle({0, 0}, {1, 1}), support::rectangle({2, 0}, {3, 1})};
  const Analysis analysis = support::plain_analysis(0.01, 5);
  Settings settings = support::standard_settings(analysis);
  settings.step_control = StepControl::constant;
  if (change) change(settings);
  Prepared prepared;
  prepared.scene = support::standard_scene_of(blocks, analysis, settings);
  return prepared;
}

StepReport step(int number) {
  StepReport report;
  report.step = number;
  report.time = 0.01 * number;
  report.dt = 0.01;
  return report;
}

/// Returns all warnings about steps that differ from a sound one.
Warnings said(const Prepared& prepared, const std::vector<std::function<void(StepReport&)>>& changes) {
  StepWatch watch(prepared);
  int number = 0;
  for (const auto& change : changes) {
    StepReport report = step(++number);
    if (change) change(report);
    watch.add(report);
  }
  return watch.warnings({"in.ana", 7, 0});
}

std::string sentence(const Warnings& warnings, const std::string& name) {
  const auto found = std::ranges::find(warnings, name, &Warning::name);
  return found == warnings.end() ? std::string() : found->sentence;
}

/// Returns true if all of these are in a text: the counts and numbers of a sentence, not its words.
testing::AssertionResult tells(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    if (text.find(part) == std::string::npos) return testing::AssertionFailure() << part << " is not in: " << text;
  return testing::AssertionSuccess();
}

/// Returns the warnings about a frame with these bolts, broken or whole.
Frame frame_of(const std::vector<bool>& broken) {
  Frame frame;
  for (const bool is_broken : broken) {
    BoltFrame bolt{};
    bolt.is_broken = is_broken;
    bolt.number = static_cast<int>(frame.bolts.size());
    frame.bolts.push_back(bolt);
  }
  return frame;
}

}  // namespace

TEST(RunWarnings, of_sound_steps_nothing_is_said) {
  EXPECT_TRUE(said(two_blocks(), {{}, {}, {}}).empty());
}

TEST(RunWarnings, a_kind_is_told_once_with_its_first_step_and_its_place) {
  const auto moves = [](StepReport& s) { s.displacement_ratio = 1.2345; };
  const Warnings found = said(two_blocks(), {{}, moves, {}, moves});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name, "step_moves_far");
  EXPECT_EQ(found[0].place, (Place{"in.ana", 7, 0}));
  EXPECT_TRUE(tells(found[0].sentence, {"step 2", "1.23 times", "2 of 4 steps"}));
  const std::vector<std::pair<std::string, double>> values{
      {"step", 2}, {"time", 0.02}, {"concerned", 2}, {"steps", 4}, {"ratio", 1.2345}};
  EXPECT_EQ(found[0].facts.numbers, values);
}

// A ratio of 2 is a displacement of 1.5 m; blocks are 1 m wide.
TEST(RunWarnings, a_block_that_may_have_passed_another_is_told) {
  const Warnings found = said(two_blocks(), {[](StepReport& s) { s.displacement_ratio = 2; }});
  EXPECT_TRUE(tells(sentence(found, "step_passes_blocks"), {"step 1", " 1.5", "(1)", "1 of 1"}));
  EXPECT_EQ(sentence(said(two_blocks(), {[](StepReport& s) { s.displacement_ratio = 1.3; }}), "step_passes_blocks"),
            "");
}

TEST(RunWarnings, a_step_that_is_cut_or_too_long_is_told) {
  const auto half = [](StepReport& s) { s.dt = 0.005; };
  const auto twice = [](StepReport& s) { s.dt = 0.02; };
  EXPECT_TRUE(tells(sentence(said(two_blocks(), {{}, half}), "step_cut"), {"step 2", "from 0.01 to 0.005"}));
  const Prepared automatic = two_blocks([](Settings& s) { s.step_control = StepControl::shi; });
  EXPECT_TRUE(said(automatic, {half}).empty());
  EXPECT_TRUE(tells(sentence(said(automatic, {twice}), "step_above_limit"), {"step 1", "0.02", "0.01"}));
}

TEST(RunWarnings, contacts_that_do_not_settle_are_counted) {
  const auto unsettled = [](int count) { return [=](StepReport& s) { s.unsettled_contacts = count; }; };
  EXPECT_TRUE(tells(sentence(said(two_blocks(), {unsettled(1), unsettled(5)}), "unsettled_step_accepted"),
                    {"step 1: 1 contact "}));
  EXPECT_TRUE(
      tells(sentence(said(two_blocks(), {{}, unsettled(3)}), "unsettled_step_accepted"), {"step 2: 3 contacts "}));
}

// Ten times the limit in contact.
TEST(RunWarnings, blocks_deep_in_one_another_are_told_by_how_much_is_allowed) {
  const Prepared prepared = two_blocks();
  const double allowed = prepared.scene.settings.open_close.allowed_penetration * prepared.scene.model.scale;
  EXPECT_GT(allowed, 0);
  const auto deep = [&](double times) { return [=](StepReport& s) { s.greatest_penetration = times * allowed; }; };
  EXPECT_EQ(sentence(said(prepared, {deep(9.9)}), "deep_penetration"), "");
  EXPECT_TRUE(tells(sentence(said(prepared, {deep(12)}), "deep_penetration"), {"12 times"}));
}

TEST(RunWarnings, under_the_old_rules_equations_are_judged_and_not_forces) {
  const Prepared old = two_blocks([](Settings& s) { s.dynamics = Dynamics::shi; });
  const auto residual = [](double value) { return [=](StepReport& s) { s.residual = value; }; };
  EXPECT_TRUE(said(old, {residual(1e-10)}).empty());
  const Warnings found = said(old, {residual(1e-8), residual(1e-10), residual(2e-7)});
  EXPECT_TRUE(tells(sentence(found, "large_residual"), {"2 of 3 steps", "1e-09", "step 3 (time 0.03)", "2.0e-07"}));
  EXPECT_TRUE(said(two_blocks(), {residual(1e-8)}).empty());
}

TEST(RunWarnings, a_watch_that_is_saved_goes_on_as_it_was) {
  const Prepared prepared = two_blocks();
  StepWatch whole(prepared), first(prepared), second(prepared);
  for (int number = 1; number <= 6; ++number) {
    StepReport report = step(number);
    report.locked_overlaps = number % 2;
    report.residual = 1e-5 * number;
    whole.add(report);
    if (number <= 3) first.add(report);
    if (number == 3) {
      Archive saved;
      first.describe(saved);
      Archive again = archive_of_checkpoint("a.h5", checkpoint_bytes(saved));
      second.describe(again);
    }
    if (number > 3) second.add(report);
  }
  EXPECT_EQ(second.warnings({}), whole.warnings({}));
  EXPECT_EQ(whole.warnings({}).size(), 2U);
}

TEST(RunWarnings, an_equilibrium_of_each_step_is_all_of_the_way) {
  StepWatch watch(two_blocks([](Settings& s) { s.standard.motion = MotionRule::equilibrium; }));
  EXPECT_FALSE(watch.equilibrium_way()) << "no step yet";
  watch.add(step(1));
  ASSERT_TRUE(watch.equilibrium_way());
  EXPECT_EQ(watch.equilibrium_way()->share, 1);
  EXPECT_TRUE(watch.is_static());
  StepWatch moving(two_blocks());
  moving.add(step(1));
  EXPECT_FALSE(moving.is_static());
  EXPECT_FALSE(moving.equilibrium_way());
}

TEST(RunWarnings, a_start_that_is_not_the_one_asked_for_is_told) {
  RunOutcome outcome;
  EXPECT_TRUE(outcome_warnings(two_blocks(), outcome, {}).empty());
  outcome.start.made = "that of elastic blocks";
  outcome.start.why = "two of them are wedged";
  outcome.start.misfit = 2e-3;
  outcome.start.unsolved_steps = 1;
  outcome.start.unbalanced = "block 2 begins suddenly";
  const Warnings found = outcome_warnings(two_blocks(), outcome, {"in.ana", 1, 2});
  ASSERT_EQ(found.size(), 4U);
  EXPECT_NE(found[0].sentence.find("several possible sets, that of elastic blocks, because two of them are wedged"),
            std::string::npos);
  EXPECT_TRUE(tells(found[1].sentence, {"2.0e-03"}));
  EXPECT_TRUE(tells(found[2].sentence, {"1 step "}));
  EXPECT_EQ(to_string(found[3]), "in.ana:1:2: warning: block 2 begins suddenly [start_without_rest]");
  outcome.start.unsolved_steps = 2;
  EXPECT_TRUE(tells(outcome_warnings(two_blocks(), outcome, {})[2].sentence, {"2 steps "}));
}

// A table that ends at the end of the run, or at zero, is continued without a message.
TEST(RunWarnings, a_table_that_ends_before_the_run_is_told_at_its_place) {
  Prepared prepared = two_blocks();
  TimeCurve early{{0, 1}, {{0, 0}, {3, 0}}, {"in.ana", 12, 1}};
  TimeCurve to_nothing = early, long_enough = early;
  to_nothing.values.back() = {};
  long_enough.times.back() = 2;
  for (const TimeCurve& curve : {to_nothing, early, long_enough, TimeCurve{}})
    prepared.scene.model.loading_points.push_back({{0.5, 0.5}, ElementIndex{0}, curve});
  prepared.scene.settings.body_acceleration.curve = early;
  RunOutcome outcome;
  outcome.time = 2;
  const Warnings found = outcome_warnings(prepared, outcome, {"other", 0, 0});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].name, "load_held_after_table");
  EXPECT_EQ(found[0].place, (Place{"in.ana", 12, 1}));
  EXPECT_TRUE(tells(found[0].sentence, {"time 1", "run at 2"}));
  EXPECT_EQ(found[1].name, "acceleration_held_after_table");
}

// A single row is a constant load, and a table may begin with nothing.
TEST(RunWarnings, a_table_that_begins_after_the_run_is_told_at_its_place) {
  Prepared prepared = two_blocks();
  TimeCurve late{{1, 2}, {{3, 0}, {0, 0}}, {"in.ana", 12, 1}};
  TimeCurve from_nothing = late, at_once = late;
  from_nothing.values = {{0, 0}, {0, 0}};
  at_once.times.front() = 0;
  for (const TimeCurve& curve : {from_nothing, late, at_once, TimeCurve{{1}, {{0, 0}}, {}}})
    prepared.scene.model.loading_points.push_back({{0.5, 0.5}, ElementIndex{0}, curve});
  prepared.scene.settings.body_acceleration.curve = late;
  RunOutcome outcome;
  outcome.time = 2;
  const Warnings found = outcome_warnings(prepared, outcome, {"other", 0, 0});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].name, "load_held_before_table");
  EXPECT_EQ(found[0].place, (Place{"in.ana", 12, 1}));
  EXPECT_TRUE(tells(found[0].sentence, {"begins at time 1", "from the start"}));
  EXPECT_EQ(found[1].name, "acceleration_held_before_table");
}

TEST(RunWarnings, without_a_ledger_energy_is_not_judged) {
  const Prepared prepared = two_blocks([](Settings& s) { s.ledger = Bookkeeping::off; });
  const Warnings found = outcome_warnings(prepared, {}, {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name, "energy_not_judged");
}

TEST(RunWarnings, of_many_bolts_that_broke_ten_are_named) {
  const std::vector<bool> none(30, false);
  std::vector<bool> broken(30, false);
  for (int i = 0; i < 10; ++i) broken[static_cast<std::size_t>(2 * i)] = true;
  EXPECT_TRUE(tells(broken_bolts(frame_of(none), frame_of(broken), {})[0].sentence,
                    {"10 of 30 bolts", ": 1, 3, 5, 7, 9, 11, 13, 15, 17, 19;"}));
  broken[29] = broken[28] = true;
  EXPECT_TRUE(
      tells(broken_bolts(frame_of(none), frame_of(broken), {})[0].sentence, {"12 of 30 bolts", "17, 19 and 2 more"}));
  EXPECT_TRUE(tells(broken_bolts(frame_of({false}), frame_of({true}), {})[0].sentence, {"1 of 1 bolt "}));
}

}  // namespace keyblock::run_warnings_test
