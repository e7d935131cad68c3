// The public library as an outside program uses it; two runs in one process do not affect each other.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <keyblock/keyblock.hpp>
#include <keyblock/record.hpp>
#include <keyblock/studies.hpp>
#include <nlohmann/json.hpp>
#include <numbers>
#include <thread>

#include "tests/library/example_cases.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::api_test {
namespace {

constexpr const char* kFriction = "/analysis/joint_materials/0/friction_angle_deg";
constexpr double kRadian = std::numbers::pi / 180;

/// Returns the displacement of the last block.
double way(const kb::Frame& frame) {
  const auto moved = frame.displacement();
  return std::hypot(moved(moved.rows() - 1, 0), moved(moved.rows() - 1, 1));
}

/// ½ g (sin 30° - cos 30° tan φ) t².
double way_of_slide(double friction_deg, double gravity, double time) {
  return 0.5 * gravity * (std::sin(30 * kRadian) - std::cos(30 * kRadian) * std::tan(friction_deg * kRadian)) * time *
         time;
}

std::vector<double> state_after(const kb::Plan& plan, const kb::Context& context) {
  kb::Run run(plan, context);
  run.go_on();
  const auto vertices = run.frame().vertices();
  return {vertices.values().begin(), vertices.values().end()};
}

// Returns the pages of this process in memory.
long resident_pages() {
  std::ifstream file("/proc/self/statm");
  long size = 0, resident = 0;
  file >> size >> resident;
  return resident;
}

}  // namespace

TEST(Api, a_block_slides_as_theory_has_it_at_each_friction) {
  const kb::Case base = slide();
  for (const double friction : {0.0, 10.0, 20.0, 25.0}) {
    kb::Run run(
        kb::Plan(base.with(kFriction, friction), {"standard", {{"enforcement", "lagrange"}, {"basis", "rigid"}}}));
    const kb::Outcome& outcome = run.go_on();
    EXPECT_EQ(outcome.end, kb::End::finished) << outcome.reason;
    const double expected = way_of_slide(friction, 9.81, outcome.time);
    EXPECT_NEAR(way(run.frame()), expected, 1e-6 * expected) << friction;
  }
}

TEST(Api, a_value_of_a_case_is_read_and_changed_and_the_case_stays) {
  const kb::Case base = slide();
  EXPECT_EQ(base.get(kFriction), "20");
  const kb::Case other = base.with(kFriction, 12.5);
  EXPECT_EQ(other.get(kFriction), "12.5");
  EXPECT_EQ(base.get(kFriction), "20");
  EXPECT_EQ(kb::Plan(other).profile(), kb::Plan(base).profile()) << "the rules of an old file stay";
  EXPECT_EQ(code_of([&] { base.get("/analysis/no_such_thing"); }), kb::ErrorCode::choice);
  EXPECT_EQ(code_of([&] { base.with("no pointer", 1); }), kb::ErrorCode::choice);
  try {
    base.with(kFriction, "NaN");
    FAIL() << "NaN is no JSON";
  } catch (const kb::Error& error) {
    EXPECT_EQ(error.what(), std::string(kFriction) + ": expected a value as JSON, found NaN");
  }
  EXPECT_EQ(code_of([&] { base.with(kFriction, "\"steep\""); }), kb::ErrorCode::input);
}

TEST(Api, units_and_pointers_of_a_case_are_listed) {
  const kb::Case base = slide();
  EXPECT_EQ(base.units(), (std::vector<std::string>{"", "", ""}));
  const kb::Case bricks = wall(2, 1);
  EXPECT_EQ(bricks.units(), (std::vector<std::string>{"m", "kg", "s"}));
  const std::vector<std::string> expected{"/blocks/blocks/0/material", "/blocks/blocks/1/material",
                                          "/blocks/blocks/2/material"};
  EXPECT_EQ(bricks.pointers("/blocks/blocks/*/material"), expected);
  EXPECT_EQ(code_of([&] { bricks.pointers("/blocks/rocks/*"); }), kb::ErrorCode::choice);
}

// A Latin hypercube uses each of four equal parts of the range once.
TEST(Api, random_rows_are_stratified_and_repeatable) {
  const std::vector<std::string> over{kFriction + std::string("=uniform(10,30)")};
  const std::string text = kb::random_rows(over, 4, 7);
  EXPECT_EQ(text, kb::random_rows(over, 4, 7));
  EXPECT_NE(text, kb::random_rows(over, 4, 8));
  std::vector<int> parts;
  for (const auto& row : nlohmann::json::parse(text))
    parts.push_back(static_cast<int>((row.at(kFriction).get<double>() - 10) / 5));
  std::ranges::sort(parts);
  EXPECT_EQ(parts, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(code_of([&] { kb::random_rows({"no values"}, 4); }), kb::ErrorCode::choice);
}

TEST(Api, headway_has_no_name_between_searches) {
  const kb::Context context;
  EXPECT_EQ(context.headway(), (std::pair<std::string, double>{"", 0}));
  kb::Run run(kb::Plan(slide(), {}, context), context);
  run.go_on();
  EXPECT_EQ(context.headway().first, "");
}

TEST(Api, errors_name_their_place) {
  const std::string path = ::testing::TempDir() + "api_bad_case.json";
  std::ofstream(path) << "{\"keyblock\": 2,\n \"blocks\": 7}";
  try {
    kb::Case::read({path});
    FAIL() << "it was read";
  } catch (const kb::Error& error) {
    EXPECT_EQ(error.code, kb::ErrorCode::input);
    EXPECT_EQ(error.place.line, 2);
    EXPECT_NE(error.place.file.find("api_bad_case.json"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("expected"), std::string::npos);
  }
  EXPECT_EQ(code_of([&] { kb::Plan(slide(), {"no_profile", {}}); }), kb::ErrorCode::choice);
  EXPECT_EQ(code_of([&] { kb::Plan(slide(), {"", {{"no_setting", "1"}}}); }), kb::ErrorCode::choice);
  EXPECT_EQ(code_of([&] { kb::Case::read({}); }), kb::ErrorCode::choice);
}

TEST(Api, units_and_distances_that_no_drawing_has_are_refused) {
  const std::string docs = std::string(KEYBLOCK_SOURCE_DIR) + "/docs/";
  const auto refusal = [&](const kb::Drawing& drawing) {
    try {
      kb::Case::read({docs + "quarry.dxf", docs + "bench.json", docs + "quarry_layers.csv"}, drawing);
    } catch (const kb::Error& error) {
      const std::string& choice = error.place.choice;
      EXPECT_EQ(error.code, kb::ErrorCode::choice);
      EXPECT_EQ(std::string(error.what()).substr(error.choice_at, choice.size()), choice);
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal({"mm", 0.001}), "");
  EXPECT_EQ(refusal({"furlong", 0}), "unit: expected one of in, ft, mm, cm, m, km, yd, dm, found \"furlong\"");
  EXPECT_EQ(refusal({"MM", 0}).substr(0, 18), "unit: expected one");
  EXPECT_EQ(refusal({"", -1}), "join: expected a number above 0, found \"-1\"");
  EXPECT_NE(refusal({"", std::nan("")}), "");
  EXPECT_NE(refusal({"", INFINITY}), "");
}

// The word of the library, not that of the command.
TEST(Api, an_error_names_the_choice_of_its_caller) {
  const auto refusal = [](const std::function<void()>& work) {
    try {
      work();
    } catch (const kb::Error& error) {
      return std::pair(error.place.choice, std::string(error.what()));
    }
    return std::pair<std::string, std::string>();
  };
  using Pair = std::pair<std::string, std::string>;
  const std::string folder = support::fresh_folder("api_choices"), out = folder + "/out";
  const auto record = [&](const kb::Recording& how) { kb::record(slide(), out, how, {"", {{"steps", "2"}}, {}}); };
  EXPECT_EQ(refusal([&] { record({.contacts = "some"}); }),
            Pair("contacts",
                 "contacts: expected automatic, all, chosen, none, or the number of frames from one to the "
                 "next; found \"some\""));
  EXPECT_EQ(refusal([&] { record({.histories = {"blok:1"}}); }).first, "histories");
  const Pair missing = refusal([&] { record({.histories = {"block:7"}}); });
  EXPECT_EQ(missing.first, "histories");
  EXPECT_TRUE(missing.second.starts_with("histories block:7: error: expected the number of a block")) << missing.second;
  EXPECT_EQ(refusal([&] { record({.every = -1}); }), Pair("every", "every: expected at least 0, found -1"));
  EXPECT_FALSE(std::filesystem::exists(out));
  record({});
  const Pair taken = refusal([&] { record({}); });
  EXPECT_EQ(taken.first, "Recording::overwrite");
  EXPECT_TRUE(taken.second.ends_with("exists; give another name, or Recording::overwrite to overwrite it"))
      << taken.second;
  const Pair none("folder", "folder: expected the name of a folder, found an empty one");
  EXPECT_EQ(refusal([&] { kb::record(slide(), ""); }), none);
  EXPECT_EQ(refusal([&] { kb::recorded(slide(), ""); }), none);
  EXPECT_EQ(refusal([&] { kb::resume(""); }), none);
  EXPECT_EQ(refusal([&] { kb::resumed(""); }), none);
  EXPECT_EQ(refusal([&] { kb::Case::read({""}); }),
            Pair("", "\"\": error: expected the name of a file or a folder, found an empty one"));
}

// A block on a plane steeper than its friction has no equilibrium.
TEST(Api, a_failure_is_told_by_values) {
  kb::Run run(kb::Plan(slide(), {"standard", {{"motion", "static"}}}));
  const kb::Outcome& outcome = run.go_on();
  ASSERT_EQ(outcome.end, kb::End::failed);
  EXPECT_EQ(outcome.failure, "no_equilibrium");
  EXPECT_EQ(outcome.cause, "no_equilibrium");
  EXPECT_EQ(outcome.facts.blocks, std::vector<int>{2});
  EXPECT_EQ(outcome.facts.points.size(), 1U);
  const auto area = std::ranges::find(outcome.facts.numbers, "area", &std::pair<std::string, double>::first);
  ASSERT_NE(area, outcome.facts.numbers.end());
  EXPECT_NE(outcome.reason.find("block 2 accelerates"), std::string::npos) << outcome.reason;
  for (const kb::Warning& warning : outcome.warnings) EXPECT_FALSE(warning.level.empty()) << warning.code;
}

TEST(Api, a_plan_has_the_times_of_its_steps_in_all_stages) {
  const kb::Case bricks = wall(1, 1);
  const kb::Case staged = bricks.with("/stages", R"([{"steps": 1}, {"steps": 2, "set": {"time_step": "4 ms"}}])");
  const std::vector<std::pair<kb::Case, std::vector<double>>> known{{bricks, {0.0, 0.002, 0.004, 0.006}},
                                                                    {staged, {0.0, 0.002, 0.006, 0.01}}};
  for (const auto& [of, expected] : known) {
    const std::vector<double> times = kb::Plan(of).step_times();
    ASSERT_EQ(times.size(), expected.size());
    for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i], expected[i], 1e-15);
  }
}

TEST(Api, a_run_left_by_its_caller_goes_on_to_the_same_bits) {
  const kb::Plan plan(slide());
  const kb::Context context(1);
  kb::Run run(plan, context);
  run.go_on([](const kb::Run& now) { return now.last().number == 7; });
  EXPECT_EQ(run.outcome().end, kb::End::running);
  EXPECT_EQ(run.frame().step(), 7);
  EXPECT_EQ(run.go_on().steps, plan.steps());
  const auto vertices = run.frame().vertices();
  EXPECT_EQ(std::vector<double>(vertices.values().begin(), vertices.values().end()), state_after(plan, context));
  EXPECT_FALSE(run.advance());
}

// A wall has so many contacts that its loops use threads; both runs share the plan, and one sets up threads as the
// other steps.
TEST(Api, two_runs_in_two_threads_give_the_bytes_of_one_alone) {
  const kb::Plan plan(wall(30, 25), {"standard", {{"start", "sudden"}, {"steps", "2"}}});
  ASSERT_GT(plan.blocks(), 700);
  const std::vector<double> alone = state_after(plan, kb::Context(1));
  std::vector<double> beside;
  std::thread thread([&] { beside = state_after(plan, kb::Context(2)); });
  const std::vector<double> first = state_after(plan, kb::Context(3));
  thread.join();
  EXPECT_EQ(first, alone);
  EXPECT_EQ(beside, alone);
}

// A plan of NMM bodies in time holds one factorisation that all its runs solve with.
TEST(Api, two_runs_of_a_plan_on_covers_give_the_bytes_of_one_alone) {
  const kb::Plan plan(kb::Case::read({kCases + "sudden_load_on_covers/undamped"}), {"", {{"steps", "30"}}});
  const std::vector<double> alone = state_after(plan, kb::Context(1));
  std::vector<double> beside;
  std::thread thread([&] { beside = state_after(plan, kb::Context(1)); });
  EXPECT_EQ(state_after(plan, kb::Context(1)), alone);
  thread.join();
  EXPECT_EQ(beside, alone);
}

TEST(Api, a_stopped_run_leaves_the_other_alone) {
  const kb::Plan plan(slide());
  const kb::Context stopped(1), other(1);
  const std::vector<double> alone = state_after(plan, other);
  kb::Run run(plan, stopped);
  EXPECT_TRUE(run.advance());
  std::vector<double> beside;
  std::thread thread([&] { beside = state_after(plan, other); });
  stopped.stop();
  EXPECT_FALSE(run.advance());
  thread.join();
  EXPECT_EQ(run.outcome().end, kb::End::stopped);
  EXPECT_EQ(run.outcome().steps, 1);
  EXPECT_EQ(beside, alone);
  EXPECT_FALSE(other.is_stopped());
}

TEST(Api, a_thousand_plans_leave_no_memory) {
  const kb::Case base = slide();
  for (int i = 0; i < 100; ++i) kb::Run(kb::Plan(base)).advance();
  const long before = resident_pages();
  for (int i = 0; i < 1000; ++i) kb::Run(kb::Plan(base)).advance();
  EXPECT_LT(resident_pages() - before, 500) << "pages of 4 kB: a plan of one block takes some 20";
}

TEST(Api, the_factor_of_safety_of_a_block_on_a_plane_is_the_ratio_of_tangents) {
  const kb::Case steep = slide().with(kFriction, 40);
  const kb::Strength found = kb::factor_of_safety(steep);
  EXPECT_EQ(found.end, "bracketed");
  const double factor = std::tan(40 * kRadian) / std::tan(30 * kRadian);
  EXPECT_LE(*found.stands, factor * (1 + 1e-3));
  EXPECT_GE(*found.falls, factor * (1 - 1e-3));
  ASSERT_TRUE(found.standing && found.falling);
  EXPECT_LT(std::abs(found.standing->displacement()(1, 0)), 1e-3);
  EXPECT_GT(found.falling->displacement()(1, 0), found.standing->displacement()(1, 0)) << "it slides down";
  EXPECT_EQ(found.falling->names("corners"), found.standing->names("corners"));
  EXPECT_EQ(found.falling->rows("contacts"), 0U);
  const kb::Context stopped;
  stopped.stop();
  EXPECT_EQ(kb::factor_of_safety(steep, "joints", 0.01, {}, stopped).end, "stopped");
}

TEST(Api, stress_intensity_is_that_of_the_command) {
  const std::string folder = kCases + "stress_intensity/edge_crack_05";
  const std::vector<kb::Tip> tips = kb::stress_intensity(kb::Case::read({folder})).tips;
  const support::ProgramRun sif = support::run_keyblock({"sif", folder, "--json"});
  ASSERT_EQ(sif.exit_code, 0) << sif.messages;
  const nlohmann::json printed = nlohmann::json::parse(sif.output).at("tips");
  ASSERT_EQ(tips.size(), 1U);
  ASSERT_EQ(printed.size(), 1U);
  const kb::Tip& tip = tips.front();
  EXPECT_EQ(printed[0].at("at"), nlohmann::json::array({tip.x, tip.y}));
  EXPECT_EQ(printed[0].at("ahead"), nlohmann::json::array({tip.ahead_x, tip.ahead_y}));
  for (const auto& [key, value] : std::vector<std::pair<const char*, double>>{{"K_I", tip.k1},
                                                                              {"K_II", tip.k2},
                                                                              {"J", tip.j},
                                                                              {"kink_deg", tip.kink_deg},
                                                                              {"K_eq", tip.k_equivalent},
                                                                              {"spread_K_I", tip.spread}})
    EXPECT_DOUBLE_EQ(printed[0].at(key).get<double>(), value) << key;
  EXPECT_EQ(printed[0].at("doubt"), tip.doubt);
  EXPECT_GT(tip.k1, 0);
  EXPECT_EQ(code_of([&] { kb::stress_intensity(slide()); }), kb::ErrorCode::input);
}

}  // namespace keyblock::api_test
