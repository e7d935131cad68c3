// Errors relative to expected values and to the limit of refined runs; the runs that are made.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/trade/tradeoff.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/context.hpp"
#include "run/prepare.hpp"
#include "study/trade/run_design.hpp"

namespace keyblock::study::tradeoff_test {
namespace {

const std::string kCases = KEYBLOCK_SOURCE_DIR "/legacy_cases/";

ExpectedValue expected(const std::string& quantity, double time, double value, const std::string& judged) {
  ExpectedValue e;
  e.quantity = quantity;
  e.block = 1;
  e.time = time;
  e.value = value;
  e.tolerance = 0.5;
  e.judged = judged;
  return e;
}

MeasuredRun with_values(std::vector<double> values) {
  MeasuredRun run;
  run.values = std::move(values);
  return run;
}

const RunPlan* named(const std::vector<RunPlan>& plans, const std::string& name) {
  const auto found = std::ranges::find(plans, name, &RunPlan::name);
  return found == plans.end() ? nullptr : &*found;
}

std::string value_of(const RunPlan& plan, const std::string& setting) {
  const auto found = std::ranges::find(plan.set, setting, &Override::first);
  return found == plan.set.end() ? "" : found->second;
}

const OnRun kQuiet = [](const MeasuredRun&, std::size_t, std::size_t) {};

}  // namespace

TEST(Tradeoff, errors_are_relative_to_the_greatest_expected_of_a_quantity) {
  const Reference reference = expected_reference({expected("dx", 1, 2, "both"), expected("dx", 2, -8, "standard"),
                                                  expected("dx", 3, 100, "legacy"), expected("rotation", 1, 0, "both")},
                                                 "standard");
  EXPECT_DOUBLE_EQ(error_of(with_values({2.4, -8, 0, 7}), reference), 0.05);
  EXPECT_DOUBLE_EQ(error_of(with_values({2, -6, 0, 7}), reference), 0.25);
  EXPECT_TRUE(std::isinf(error_of(with_values({2, std::nan(""), 0, 7}), reference)));
}

TEST(Tradeoff, where_nothing_is_expected_to_happen_errors_are_shares_of_the_tolerance) {
  const Reference reference = expected_reference({expected("dx", 1, 0, "both")}, "standard");
  EXPECT_DOUBLE_EQ(error_of(with_values({0.1}), reference), 0.2);
}

TEST(Tradeoff, values_that_say_only_whether_something_happens_are_no_reference) {
  const std::vector<ExpectedValue> left = without_verdicts(
      {expected("dx", 1, 0.52, "both"), expected("dx", 2, -8, "both"), expected("rotation", 1, 0, "both")});
  ASSERT_EQ(left.size(), 2U);
  EXPECT_EQ(left[0].value, -8);
  EXPECT_EQ(left[1].value, 0);
}

TEST(Tradeoff, a_run_that_did_not_finish_has_no_error) {
  MeasuredRun run = with_values({1});
  run.end = MeasuredEnd::over_limit;
  EXPECT_TRUE(std::isinf(error_of(run, expected_reference({expected("dx", 1, 1, "both")}, "standard"))));
}

TEST(Tradeoff, the_design_of_a_block_case_varies_every_choice_and_has_each_run_once) {
  const StudyCase chosen = study_case({kCases + "sliding_block/a30_p20"});
  const std::vector<RunPlan> plans = usual_design(chosen, "standard");
  for (const char* name : {"standard", "legacy", "draft", "reference", "rigid", "multipliers", "springs", "augmented",
                           "step x4", "step /4", "penalty x10", "tolerance 1e-3", "rigid, step x4", "rigid, springs"})
    EXPECT_NE(named(plans, name), nullptr) << name;
  std::set<std::string> names;
  for (const RunPlan& plan : plans) EXPECT_TRUE(names.insert(plan.name).second) << plan.name;
  EXPECT_EQ(plans.front().name, "standard");
}

TEST(Tradeoff, integrators_and_rules_of_impact_are_varied_and_forces_where_there_are_many_blocks) {
  const std::vector<RunPlan> slide = usual_design(study_case({kCases + "sliding_block/a30_p20"}), "standard");
  for (const char* name : {"Newmark", "generalised alpha", "impact on springs"})
    EXPECT_NE(named(slide, name), nullptr) << name;
  EXPECT_EQ(named(slide, "forces to 1e-3"), nullptr);
  const std::vector<RunPlan> wall = usual_design(study_case({kCases + "voussoir_beam/elastic_slender"}), "standard");
  ASSERT_NE(named(wall, "forces to 1e-3"), nullptr);
  EXPECT_EQ(value_of(*named(wall, "forces to 1e-3"), "force_tolerance"), "1e-3");
}

TEST(Tradeoff, a_plan_is_refined_by_its_step_its_tolerance_or_its_mesh) {
  const StudyCase slide = study_case({kCases + "sliding_block/a30_p20"});
  const RunPlan own{"standard", "profile", "standard", {}, {}, 1};
  const auto quarter = refined(slide, "standard", own, 4);
  ASSERT_TRUE(quarter);
  EXPECT_EQ(quarter->name, "step /4");
  EXPECT_EQ(value_of(*quarter, "steps"), "4000");
  EXPECT_EQ(refined(slide, "standard", *quarter, 2)->name, "step /8");
  EXPECT_EQ(value_of(*refined(slide, "standard", *quarter, 2), "steps"), "8000");
  const RunPlan rigid{"rigid, step x2",
                      "basis and step",
                      "standard",
                      {{"basis", "rigid"}, {"time_step", "0.002"}, {"steps", "500"}},
                      {},
                      1};
  EXPECT_EQ(refined(slide, "standard", rigid, 4)->name, "rigid, step /2");
  const RunPlan by_error{
      "tolerance 1e-3", "tolerance", "standard", {{"step_control", "error"}, {"step_tolerance", "1e-3"}}, {}, 1};
  EXPECT_EQ(std::stod(value_of(*refined(slide, "standard", by_error, 4), "step_tolerance")), 2.5e-4);
  const auto mesh = refined(study_case({kCases + "cook_membrane/coarse"}), "standard", own, 2);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->name, "side /2");
}

// The file: 1000 steps of 1 ms, values expected at quarters of a second.
// The profile derives its steps from the given ones: draft halves their number, reference takes four times as many.
TEST(Tradeoff, a_profile_with_a_step_of_its_own_is_refined_by_so_many_parts_and_no_more) {
  const StudyCase slide = study_case({kCases + "sliding_block/a30_p20"});
  for (const std::string profile : {"draft", "reference"}) {
    const RunPlan own{profile, "profile", profile, {}, {}, 1};
    const auto steps_of = [&](const RunPlan& plan) {
      std::vector<Override> overrides = slide.overrides(plan.profile);
      overrides.insert(overrides.end(), plan.set.begin(), plan.set.end());
      return prepare(slide.input.problem, plan.profile, overrides).scene.settings;
    };
    const Settings before = steps_of(own);
    const auto half = refined(slide, "standard", own, 2);
    ASSERT_TRUE(half);
    EXPECT_EQ(half->name, profile + ", step /2");
    EXPECT_EQ(steps_of(*half).step_count, 2 * before.step_count);
    EXPECT_NEAR(steps_of(*half).time_step, before.time_step / 2, 1e-12 * before.time_step);
  }
}

TEST(Tradeoff, a_refined_name_keeps_the_other_levels_and_loses_a_step_that_is_the_own_one) {
  const StudyCase slide = study_case({kCases + "sliding_block/a30_p20"});
  const std::vector<Override> coarse{{"time_step", "0.008"}, {"steps", "125"}};
  const RunPlan joined{"rigid, step x8, springs", "all", "standard", coarse, {}, 1};
  EXPECT_EQ(refined(slide, "standard", joined, 2)->name, "rigid, springs, step x4");
  EXPECT_EQ(refined(slide, "standard", joined, 8)->name, "rigid, springs");
  const RunPlan alone{"step x8", "step", "standard", coarse, {}, 1};
  EXPECT_EQ(refined(slide, "standard", alone, 8)->name, "standard");
}

TEST(Tradeoff, steps_are_varied_so_that_the_run_ends_at_the_same_time) {
  const std::vector<RunPlan> plans = usual_design(study_case({kCases + "sliding_block/a30_p20"}), "standard");
  for (const char* name : {"step x8", "step x4", "step x2", "step /2", "step /4"}) {
    const RunPlan* plan = named(plans, name);
    ASSERT_NE(plan, nullptr) << name;
    const int steps = std::stoi(value_of(*plan, "steps"));
    EXPECT_NEAR(steps * std::stod(value_of(*plan, "time_step")), 1, 1e-12) << name;
    EXPECT_EQ(steps % 4, 0) << name;
  }
  EXPECT_EQ(named(plans, "step /2")->coarser, "standard");
  EXPECT_EQ(named(plans, "rigid, step /4")->coarser, "rigid, step /2");
  EXPECT_EQ(named(plans, "rigid, step /2")->coarser, "rigid");
}

TEST(Tradeoff, a_case_on_covers_varies_functions_and_mesh) {
  const std::vector<RunPlan> plans = usual_design(study_case({kCases + "cook_membrane/coarse"}), "standard");
  EXPECT_EQ(named(plans, "legacy"), nullptr);
  EXPECT_EQ(named(plans, "rigid"), nullptr);
  const RunPlan* plan = named(plans, "quadratic, side x2");
  ASSERT_NE(plan, nullptr);
  EXPECT_EQ(value_of(*plan, "functions"), "quadratic");
  EXPECT_EQ(named(plans, "linear, side /2")->coarser, "linear");
}

TEST(Tradeoff, a_mesh_by_error_is_varied_by_its_error) {
  const StudyCase plate = study_case({kCases + "stress_intensity/edge_crack_05_by_error"});
  const std::vector<RunPlan> plans = usual_design(plate, "standard", {"mesh"});
  const RunPlan* finer = named(plans, "mesh error /2");
  ASSERT_NE(finer, nullptr);
  EXPECT_EQ(value_of(*finer, "mesh.error"), "0.01");
  EXPECT_EQ(named(plans, "side /2"), nullptr);
  const RunPlan own{"standard", "profile", "standard", {}, {}, 1};
  const MeasuredRun coarse = measured_run(plate, *named(plans, "mesh error x4"), {});
  const MeasuredRun usual = measured_run(plate, own, {});
  EXPECT_LT(coarse.unknowns, usual.unknowns);
  EXPECT_LT(usual.unknowns, measured_run(plate, *finer, {}).unknowns);
}

TEST(Tradeoff, the_full_design_keeps_to_its_cap) {
  const StudyCase chosen = study_case({kCases + "sliding_block/a30_p20"});
  EXPECT_EQ(full_design(chosen, "standard", 40).size(), 40U);
  EXPECT_NE(named(full_design(chosen, "standard", 1000), "rigid, step x4, augmented"), nullptr);
}

TEST(Tradeoff, refinements_are_three_halvings_down_to_the_finest) {
  const StudyCase chosen = study_case({kCases + "sliding_block/a30_p20"});
  const std::vector<RunPlan> plans = refinements(chosen, "standard", 16);
  ASSERT_EQ(plans.size(), 3U);
  EXPECT_EQ(plans[0].name, "step /4");
  EXPECT_EQ(plans[2].name, "step /16");
  EXPECT_EQ(refinements(chosen, "standard", 4).front().name, "standard");
}

TEST(Tradeoff, the_standard_slide_is_exact_and_legacy_lags) {
  StudyCase chosen = study_case({kCases + "sliding_block/a30_p20"});
  const std::vector<RunPlan> plans{{"standard", "profile", "standard", {}, {}, 1},
                                   {"legacy", "profile", "legacy", {}, {}, 1}};
  const Tradeoff result = tradeoff(chosen, plans, {}, {}, kQuiet);
  EXPECT_LT(error_of(result.runs[0], result.reference), 1e-6);
  // Friction a step late: g cos a tan phi dt of the speed, some 1e-3 of it.
  EXPECT_NEAR(error_of(result.runs[1], result.reference), 2e-3, 1.5e-3);
  EXPECT_GT(result.runs[0].seconds, 0);
  EXPECT_EQ(result.runs[0].steps, 1000);
}

TEST(Tradeoff, runs_over_the_limit_are_ended_and_finer_ones_left_out) {
  StudyCase chosen = study_case({kCases + "sliding_block/a30_p20"});
  const std::vector<RunPlan> plans{{"standard", "profile", "standard", {}, {}, 1},
                                   {"finer", "step", "standard", {}, "standard", 1.5}};
  const Tradeoff result = tradeoff(chosen, plans, {}, {1, 1e-4}, kQuiet);
  EXPECT_EQ(result.runs[0].end, MeasuredEnd::over_limit);
  EXPECT_EQ(result.runs[1].end, MeasuredEnd::over_limit);
  EXPECT_EQ(result.runs[1].timings, 0);
  EXPECT_TRUE(result.front.empty());
}

TEST(Tradeoff, a_stop_ends_the_run_at_hand_and_all_after_it_and_keeps_those_before) {
  const StudyCase fall = study_case({kCases + "free_fall/released"});
  const std::vector<RunPlan> plans = usual_design(fall, "standard", {"step"});
  ASSERT_GT(plans.size(), 4U);
  const Context own;
  const Under under(own);
  std::size_t told = 0;
  const Tradeoff result = tradeoff(fall, plans, {}, {}, [&](const MeasuredRun&, std::size_t done, std::size_t) {
    if (done == 2) own.stop();
    ++told;
  });
  EXPECT_TRUE(result.is_stopped);
  EXPECT_EQ(told, 2U);
  ASSERT_EQ(result.runs.size(), plans.size());
  for (std::size_t i = 0; i < plans.size(); ++i) {
    EXPECT_EQ(result.runs[i].plan.name, plans[i].name);
    EXPECT_EQ(result.runs[i].end, i < 2 ? MeasuredEnd::finished : MeasuredEnd::stopped) << i;
  }
  EXPECT_FALSE(result.front.empty());
}

TEST(Tradeoff, without_the_runs_that_errors_are_measured_against_a_stop_leaves_costs_alone) {
  StudyCase fall = study_case({kCases + "free_fall/released"});
  fall.expected.clear();
  const std::vector<RunPlan> plans = usual_design(fall, "standard", {"step"});
  const Context own;
  const Under under(own);
  const Tradeoff result = tradeoff(fall, plans, refinements(fall, "standard", 4), {},
                                   [&](const MeasuredRun&, std::size_t, std::size_t) { own.stop(); });
  EXPECT_TRUE(result.is_stopped);
  EXPECT_TRUE(result.front.empty());
  EXPECT_TRUE(result.reference.doubt.starts_with("stopped before the end of")) << result.reference.doubt;
  EXPECT_TRUE(std::isinf(error_of(result.runs.front(), result.reference)));
}

TEST(Tradeoff, settings_that_do_not_fit_are_refused_and_the_others_go_on) {
  StudyCase chosen = study_case({kCases + "sliding_block/a30_p20"});
  const std::vector<RunPlan> plans{
      {"misfit", "x", "standard", {{"impact", "springs"}, {"enforcement", "lagrange"}}, {}, 1},
      {"standard", "profile", "standard", {{"steps", "1000"}}, {}, 1}};
  const Tradeoff result = tradeoff(chosen, plans, {}, {}, kQuiet);
  EXPECT_EQ(result.runs[0].end, MeasuredEnd::refused);
  EXPECT_EQ(result.front, std::vector<std::size_t>{1});
}

TEST(Tradeoff, the_map_has_every_penalty_with_every_step) {
  const std::vector<RunPlan> plans =
      penalty_step_map(study_case({kCases + "sliding_block/a30_p20"}), "standard", {10, 1}, {2, 1, 0.5});
  ASSERT_EQ(plans.size(), 6U);
  EXPECT_EQ(plans[0].name, "penalty x10, step x2");
  EXPECT_EQ(value_of(plans[0], "enforcement"), "penalty");
  EXPECT_DOUBLE_EQ(std::stod(value_of(plans[0], "contact_penalty")),
                   10 * std::stod(value_of(plans[3], "contact_penalty")));
  EXPECT_EQ(value_of(plans[1], "steps"), "");
}

}  // namespace keyblock::study::tradeoff_test
