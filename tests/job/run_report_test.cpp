// The record of a run made by hand, read back as JSON.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/run_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "settings/settings_table.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::run_report_test {
namespace {

using Json = nlohmann::ordered_json;

Prepared two_blocks() {
  Blocks blocks;
  blocks.blocks = {support::rectangle({0, 0}, {1, 1}), support::rectangle({2, 0}, {3, 1})};
  blocks.fixed_points = {{{0.5, 0.5}, 0, {}}};
  const Analysis analysis = support::plain_analysis(0.01, 5);
  Prepared prepared;
  prepared.scene = support::standard_scene_of(blocks, analysis, support::standard_settings(analysis));
  prepared.requirements = {12, "affine, 2 blocks", {{TermKind::inertia, "they move"}, {TermKind::contact, "they may"}}};
  return prepared;
}

StepReport step(int number, int passes) {
  StepReport report;
  report.step = number;
  report.time = 0.01 * number;
  report.dt = 0.01 / number;
  report.passes = passes;
  report.redos = 2;
  report.contacts = 10 * number;
  report.greatest_penetration = 1e-5 * number;
  return report;
}

/// Three steps were made.
RunRecord record() {
  RunRecord made;
  made.profile = "standard";
  made.profile_because = "the case says so";
  made.inputs = {{"a \"b\"\\\n.geo", "abc", "dda", "its name"}, {"sör.ana", "def", "dda", "its first line"}};
  for (const auto& [number, passes] : {std::pair(1, 0), std::pair(2, 4), std::pair(3, 41)}) {
    made.totals.add(step(number, passes));
    made.steps.add(step(number, passes));
  }
  made.outcome.steps = 3;
  made.outcome.time = 0.03;
  made.extremes = {0.25, 1, {2, 0}, -7, 0, 8, 1, 0.9, 0};
  made.timings = {1, 2, 3};
  made.record_every = 4;
  made.outputs = {"history.csv", "picture.svg"};
  return made;
}

/// As a program reads the file.
Json read(const RunRecord& of, const Prepared& prepared = two_blocks()) {
  return Json::parse(run_json(prepared, of).dump(1));
}

Warning warning(const std::string& name, int line) {
  return {name, {"in.geo", line, 1}, "a sentence"};
}

std::vector<std::string> options_of(const std::vector<Remedy>& remedies) {
  std::vector<std::string> options;
  for (const Remedy& remedy : remedies) options.push_back(remedy.option);
  return options;
}

}  // namespace

TEST(RunReport, a_record_says_what_went_in_and_what_was_chosen) {
  const Json json = read(record());
  EXPECT_EQ(json["program"], "keyblock");
  EXPECT_EQ(json["profile"], "standard");
  EXPECT_EQ(json["profile_because"], "the case says so");
  ASSERT_EQ(json["inputs"].size(), 2U);
  EXPECT_EQ(json["inputs"][0]["file"], "a \"b\"\\\n.geo");
  EXPECT_EQ(json["inputs"][1]["file"], "sör.ana");
  EXPECT_EQ(json["inputs"][1]["sha256"], "def");
  EXPECT_EQ(json["requirements"]["unknowns"], 12);
  EXPECT_EQ(json["requirements"]["terms"][1]["term"], name_of(TermKind::contact));
  EXPECT_EQ(json["requirements"]["terms"][1]["reason"], "they may");
  EXPECT_EQ(json["seconds"], Json({{"read", 1}, {"prepare", 2}, {"run", 3}}));
  EXPECT_EQ(json["recorded_every"], 4);
  EXPECT_EQ(json["outputs"], Json({"history.csv", "picture.svg"}));
  EXPECT_FALSE(json.contains("units"));
  EXPECT_FALSE(json.contains("unit_of"));
  EXPECT_FALSE(json.contains("ledger")) << "no energy balance was kept";
}

TEST(RunReport, numbers_of_elements_count_from_1) {
  RunRecord made = record();
  made.left_out = {0, 4};
  made.held = {1};
  const Json json = read(made);
  EXPECT_EQ(json["extremes"]["greatest_displacement"], Json({{"value", 0.25}, {"element", 2}}));
  EXPECT_EQ(json["extremes"]["least_principal_stress"], Json({{"value", -7}, {"element", 1}}));
  EXPECT_EQ(json["extremes"]["greatest_principal_stress"]["element"], 2);
  EXPECT_EQ(json["extremes"]["least_area_share"]["value"], 0.9);
  EXPECT_EQ(json["left_out"], Json({1, 5}));
  EXPECT_EQ(json["held"], Json({2}));
  const Json none = read(record());
  EXPECT_FALSE(none.contains("left_out"));
  EXPECT_TRUE(none["held"].is_array() && none["held"].empty());
}

// Bins end at 0, 3, 10 and 40 iterations; the last has no end.
TEST(RunReport, counts_are_sums_and_bounds_of_the_steps) {
  const Json counts = read(record())["counts"];
  EXPECT_EQ(counts["blocks"], 2);
  EXPECT_EQ(counts["vertices"], 8);
  EXPECT_EQ(counts["fixed_points"], 1);
  EXPECT_EQ(counts["most_contacts"], 30);
  EXPECT_EQ(counts["passes"], 45);
  EXPECT_EQ(counts["most_passes"], 41);
  EXPECT_EQ(counts["redone_attempts"], 6);
  EXPECT_EQ(counts["least_dt"], 0.01 / 3);
  EXPECT_EQ(counts["greatest_dt"], 0.01);
  EXPECT_EQ(counts["greatest_penetration"], 1e-5 * 3);
  const Json expected = Json::parse(R"([{"from": 0, "to": 0, "steps": 1}, {"from": 1, "to": 3, "steps": 0},
    {"from": 4, "to": 10, "steps": 1}, {"from": 11, "to": 40, "steps": 0}, {"from": 41, "to": null, "steps": 1}])");
  EXPECT_EQ(counts["steps_by_passes"], expected);
  EXPECT_FALSE(counts.contains("snaps")) << "nothing was cut";
}

TEST(RunReport, a_run_without_steps_has_no_bounds) {
  RunRecord made = record();
  made.totals = {};
  EXPECT_FALSE(read(made)["counts"].contains("least_dt"));
}

TEST(RunReport, a_failed_run_names_its_reason_contacts_blocks_and_remedies) {
  RunRecord made = record();
  made.outcome.end = RunEnd::failed;
  made.outcome.reason = "no equilibrium";
  made.outcome.failure = FailureKind::no_equilibrium;
  made.outcome.contacts = {0, 6};
  made.outcome.numbers = {2};
  made.doubts = {warning("energy_beyond_limit", 1)};
  Prepared prepared = two_blocks();
  prepared.scene.settings.standard.motion = MotionRule::equilibrium;
  const Json outcome = read(made, prepared)["outcome"];
  EXPECT_EQ(outcome["end"], "failed");
  EXPECT_EQ(outcome["reason"], "no equilibrium");
  EXPECT_EQ(outcome["failure"], "no_equilibrium");
  EXPECT_EQ(outcome["contacts"], Json({1, 7}));
  EXPECT_EQ(outcome["blocks"], Json({2})) << "numbers as tables have them";
  EXPECT_EQ(outcome["try"][0], "--set motion=dynamic");
  EXPECT_EQ(outcome["doubts"], Json({"a sentence"}));
  const Json finished = read(record())["outcome"];
  EXPECT_EQ(finished["end"], "finished");
  for (const char* key : {"reason", "failure", "contacts", "try", "ended_early"})
    EXPECT_FALSE(finished.contains(key)) << key;
  EXPECT_TRUE(finished["doubts"].is_array() && finished["doubts"].empty());
}

TEST(RunReport, every_setting_stands_under_its_name) {
  Settings settings = two_blocks().scene.settings;
  settings.time_step = 1.0 / 3;
  const Json json = Json::parse(all_settings_json(settings).dump());
  EXPECT_EQ(json.size(), list(settings).size());
  EXPECT_EQ(json["time_step"].get<double>(), 1.0 / 3);
  for (const SettingText& setting : list(settings)) {
    ASSERT_TRUE(json.contains(setting.name)) << setting.name;
    EXPECT_TRUE(json[setting.name].is_string() != setting.is_number) << setting.name;
  }
}

TEST(RunReport, a_setting_without_a_bound_is_null) {
  Settings settings = two_blocks().scene.settings;
  settings.trust.energy = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(Json::parse(all_settings_json(settings).dump())["energy_limit"].is_null());
}

TEST(RunReport, steps_name_their_table_its_columns_and_its_stride) {
  RunRecord made = record();
  made.units = {"m", "kg", "s"};
  const Json steps = read(made)["steps"];
  EXPECT_EQ(steps["table"], "step_table.csv");
  EXPECT_EQ(steps["columns"][1], "time [s]");
  EXPECT_EQ(steps["kept_every"], 1);
}

// Metres, kilograms and seconds: force is in newtons, stress in pascals; of a slice, per metre.
TEST(RunReport, declared_units_stand_beside_the_numbers) {
  RunRecord made = record();
  made.units = {"m", "kg", "s"};
  made.outcome.forces = ForceBalance{{{1, 2}, 3}, {{0, 0}, 0}, {{{-1, -2}, -3}}};
  const Json json = read(made);
  EXPECT_EQ(json["units"], Json({{"length", "m"}, {"mass", "kg"}, {"time", "s"}, {"force", "N"}, {"stress", "Pa"}}));
  EXPECT_EQ(json["unit_of"]["outcome.time"], "s");
  EXPECT_EQ(json["unit_of"]["extremes.least_principal_stress.value"], "Pa");
  EXPECT_EQ(json["unit_of"]["forces.supports[].x"], "N/m");
  EXPECT_FALSE(json["unit_of"].contains("counts.blocks"));
  EXPECT_EQ(json["forces"]["loads"], Json({{"x", 1}, {"y", 2}, {"moment", 3}}));
  EXPECT_EQ(json["forces"]["supports"][0]["moment"], -3);
  EXPECT_EQ(json["forces"]["unbalanced"], 0);
}

TEST(RunReport, a_held_edge_is_a_support_with_its_direction) {
  RunRecord made = record();
  made.supports = {{"fixed_point", {1, 2}, 1}, {"held_edge", {3, 4}, 2, {0, 1}}};
  const Json supports = read(made)["supports"];
  EXPECT_EQ(supports[0], Json({{"kind", "fixed_point"}, {"x", 1}, {"y", 2}, {"block", 1}}));
  EXPECT_EQ(supports[1], Json({{"kind", "held_edge"}, {"x", 3}, {"y", 4}, {"block", 2}, {"direction", {0, 1}}}));
}

TEST(RunReport, stages_say_their_steps_and_whether_they_came_to_rest) {
  RunRecord made = record();
  SceneReport first, second;
  first.name = "dig";
  first.last_step = 10;
  first.end_time = 0.5;
  first.asks_equilibrium = first.is_balanced = true;
  second.name = "load";
  second.first_step = 10;
  second.last_step = 30;
  made.outcome.scenes = {first, second};
  const Json stages = read(made)["stages"];
  ASSERT_EQ(stages.size(), 2U);
  EXPECT_EQ(stages[0]["name"], "dig");
  EXPECT_EQ(stages[0]["steps"], Json({1, 10}));
  EXPECT_EQ(stages[0]["balanced"], true);
  EXPECT_EQ(stages[1]["steps"], Json({11, 30}));
  EXPECT_TRUE(stages[1]["balanced"].is_null()) << "was not requested";
}

TEST(RunReport, what_was_not_found_is_null) {
  RunRecord made = record();
  made.plastic = PlasticExtremes{{}, 0.01, 2, {5, 6}};
  made.plastic->totals.area = 20;
  made.equilibrium_way = EquilibriumWay{std::nullopt, 0.5};
  ReactionCurve curve;
  curve.number = 1;
  curve.steps = {1, 2};
  curve.driven = {1, 2};
  curve.reaction = {10, 20};
  made.reactions = {curve};
  const Json json = read(made);
  EXPECT_TRUE(json["plastic"]["plastic_work"].is_null());
  EXPECT_EQ(json["plastic"]["greatest_equivalent_plastic_strain"],
            Json({{"value", 0.01}, {"element", 3}, {"x", 5}, {"y", 6}}));
  EXPECT_TRUE(json["equilibrium"]["share"].is_null());
  EXPECT_EQ(json["equilibrium"]["last_step_ratio"], 0.5);
  EXPECT_EQ(json["reactions"][0]["displacement"], 2);
  EXPECT_EQ(json["reactions"][0]["component"], "x");
  EXPECT_EQ(json["reactions"][0]["driven"], 2);
  EXPECT_EQ(json["reactions"][0]["reaction"], 20);
  EXPECT_EQ(json["reactions"][0]["slope"], 1) << "proportional";
  EXPECT_TRUE(json["reactions"][0]["plateau"].is_null());
}

TEST(RunReport, warnings_of_one_name_are_counted_and_the_first_stands_for_all) {
  Warnings warnings{warning("snapped", 3), warning("sliver", 1)};
  for (int line = 4; line < 34; ++line) warnings.push_back(warning("snapped", line));
  const Json json = Json::parse(warnings_json(warnings).dump());
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[0]["name"], "snapped");
  EXPECT_EQ(json[0]["count"], 31);
  EXPECT_EQ(json[0]["first"], to_string(warnings[0]));
  ASSERT_EQ(json[0]["others"].size(), 20U) << "of the thirty";
  EXPECT_EQ(json[0]["others"][0], to_string(warnings[2]));
  EXPECT_EQ(json[1], Json({{"name", "sliver"}, {"count", 1}, {"first", to_string(warnings[1])}}));
  EXPECT_TRUE(warnings_json({}).is_array());
}

TEST(RunReport, a_list_of_warnings_has_each_with_its_place) {
  const Json json = Json::parse(warning_list_json({warning("a", 1), warning("a", 2)}).dump());
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[1], Json({{"name", "a"}, {"file", "in.geo"}, {"line", 2}, {"column", 1}, {"sentence", "a sentence"}}));
}

TEST(RunReport, advice_is_what_the_rules_of_the_run_leave_to_try) {
  Prepared prepared = two_blocks();
  RunOutcome outcome;
  outcome.failure = FailureKind::no_equilibrium;
  EXPECT_TRUE(what_to_try(prepared, outcome).empty()) << "in time under standard";
  prepared.scene.settings.standard.motion = MotionRule::equilibrium;
  EXPECT_EQ(options_of(what_to_try(prepared, outcome)),
            (std::vector<std::string>{"--set motion=dynamic", "--profile legacy"}));
  outcome.failure = FailureKind::cracks;
  EXPECT_TRUE(what_to_try(prepared, outcome).empty());
  prepared.scene.settings.dynamics = Dynamics::shi;
  prepared.scene.settings.quirks.velocity_from_coming_step = true;
  EXPECT_EQ(options_of(what_to_try(prepared, outcome)),
            (std::vector<std::string>{"--profile standard", "--set quirk.velocity_from_coming_step=off"}));
  prepared.scene.settings.quirks.velocity_from_coming_step = false;
  EXPECT_EQ(options_of(what_to_try(prepared, outcome)), (std::vector<std::string>{"--profile standard"}));
}

}  // namespace keyblock::run_report_test
