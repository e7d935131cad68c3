// Agreement and its failures: no value, not a number, another quantity, a run that ended early.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/cases/compare.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::study::compare_test {
namespace {

namespace fs = std::filesystem;

/// Free fall (400 steps of 5 ms) with the given rows for expected values.
CaseFolder free_fall(const std::string& rows) {
  const fs::path folder = fs::path(support::fresh_folder("compare")) / "released";
  fs::copy(KEYBLOCK_SOURCE_DIR "/legacy_cases/free_fall/released", folder);
  support::write_text(folder / "expected.csv", rows);
  return find_cases({folder.string()}).front();
}

ComparedCase compared(const std::string& rows) {
  const std::string head = "quantity,block,time,value,tolerance,tolerance_reason,source\n";
  return compare_in(free_fall(head + rows), {"legacy"}).plain.front();
}

/// Both profiles and all variants; `rows` end with the run whose value is compared.
CaseComparison judged(const std::string& rows, const std::string& case_file) {
  const CaseFolder folder = free_fall("quantity,block,time,value,tolerance,tolerance_reason,source,judged\n" + rows);
  support::write_text(folder.folder / "case.json", case_file);
  return compare_in(folder, {"legacy", "standard"});
}

const std::string kRight = "dy,2,1,-4.905,1e-9,r,s,";
const std::string kWrong = "dy,2,1,-5,1e-9,r,s,";

ComparedValue value(std::optional<double> computed, double tolerance) {
  ComparedValue v;
  v.expected = 1;
  v.computed = computed;
  v.tolerance = tolerance;
  return v;
}

}  // namespace

TEST(Compare, a_value_holds_within_its_tolerance_and_only_if_there_is_one) {
  EXPECT_TRUE(value(1.25, 0.25).holds());
  EXPECT_TRUE(value(0.75, 0.25).holds());
  EXPECT_FALSE(value(1.26, 0.25).holds());
  EXPECT_FALSE(value(0.74, 0.25).holds());
  EXPECT_FALSE(value(std::nullopt, 10).holds());
  EXPECT_FALSE(value(std::nan(""), 10).holds());
  EXPECT_FALSE(value(1, std::nan("")).holds());
}

TEST(Compare, a_listed_miss_is_none_and_a_listed_value_that_holds_or_was_not_computed_is_one) {
  const auto listed = [](std::optional<double> computed) {
    ComparedValue v = value(computed, 0.25);
    v.listed_miss = "known";
    return v;
  };
  EXPECT_FALSE(listed(2).is_missed());
  EXPECT_TRUE(listed(2).is_listed_miss());
  EXPECT_TRUE(listed(1).is_missed()) << "the list is out of date";
  EXPECT_TRUE(listed(std::nullopt).is_missed());
  EXPECT_TRUE(listed(std::nan("")).is_missed());
  EXPECT_TRUE(value(2, 0.25).is_missed());
  EXPECT_FALSE(value(2, 0.25).is_listed_miss());
}

TEST(Compare, a_case_holds_if_the_run_finished_and_every_value_holds) {
  ComparedCase good;
  good.values = {value(1, 0.1), value(1, 0.1)};
  EXPECT_TRUE(good.holds());
  ComparedCase stopped = good;
  stopped.outcome.end = RunEnd::failed;
  EXPECT_FALSE(stopped.holds());
  ComparedCase off = good;
  off.values[1].computed = 2;
  EXPECT_FALSE(off.holds());
}

// s = g t²/2 = 1.22625 at 0.5 s, 4.905 at 1 s.
TEST(Compare, values_are_picked_at_their_block_and_time) {
  const ComparedCase fall =
      compared("dy,2,0.5,-1.22625,1e-9,r,s\ndy,2,1,-4.905,1e-9,r,s\ndy,1,1,0,1e-3,r,s\nblock_count,,1,2,0,r,s\n");
  EXPECT_TRUE(fall.holds());
  EXPECT_EQ(fall.times.size(), 401U);
  EXPECT_NEAR(fall.displacements[100], 1.22625, 1e-9);
  EXPECT_EQ(fall.start.step, 0);
  EXPECT_EQ(fall.end.step, 400);
}

// A block of 4 m² and 2500 kg/m³ above fixed ground: p = m g t, T = m (g t)²/2 at 1 s.
TEST(Compare, momentum_and_kinetic_energy_of_free_fall) {
  const CaseComparison fall = judged(
      "vy,2,1,-9.81,1e-9,r,s,standard\nmomentum_y,,1,-98100,1e-6,r,s,standard\n"
      "kinetic_energy,,1,481180.5,1e-5,r,s,standard\nconverged_share,,1,1,0,r,s,both\n",
      "{}");
  for (const ComparedCase& run : fall.plain)
    for (const ComparedValue& v : run.values) EXPECT_FALSE(v.is_missed()) << v.quantity << ' ' << *v.computed;
}

// Free fall in steps of 5 ms: half-way between two of them the chord lies g dt²/8 above the parabola.
TEST(Compare, between_two_frames_values_are_linear) {
  const double at = 0.5025;
  const double chord = -9.81 * at * at / 2 - 9.81 * 0.005 * 0.005 / 8;
  EXPECT_TRUE(compared(fmt::format("dy,2,{},{},1e-9,r,s\n", at, chord)).holds());
}

TEST(Compare, a_time_that_the_run_does_not_reach_does_not_hold) {
  const ComparedCase fall = compared("dy,2,5,0,1e9,r,s\n");
  EXPECT_FALSE(fall.values[0].computed);
  EXPECT_FALSE(fall.holds());
}

TEST(Compare, an_unknown_quantity_or_block_is_refused) {
  EXPECT_THROW(compared("colour,2,1,0,1,r,s\n"), InputError);
  EXPECT_THROW(compared("momentum_x,2,1,0,1,r,s\n"), InputError) << "a quantity of the scene, not of a block";
  EXPECT_THROW(compared("px,99,1,0,1,r,s\n"), InputError);
  EXPECT_THROW(compared("dy,3,1,0,1,r,s\n"), InputError);
  EXPECT_THROW(compared("dy,0,1,0,1,r,s\n"), InputError);
  EXPECT_THROW(compared("dy,2,1,nan,1,r,s\n"), InputError);
}

TEST(Compare, a_wrong_value_is_missed_only_in_the_profile_that_is_judged) {
  const CaseComparison of_legacy = judged(kRight + "both\n" + kWrong + "legacy\n", "{}");
  EXPECT_FALSE(of_legacy.plain[0].holds());
  EXPECT_TRUE(of_legacy.plain[1].holds());
  EXPECT_FALSE(of_legacy.holds());
  EXPECT_NEAR(of_legacy.plain[1].values[1].error(), 0.095, 1e-9) << "shown all the same";
  const CaseComparison of_standard = judged(kRight + "both\n" + kWrong + "standard\n", "{}");
  EXPECT_TRUE(of_standard.plain[0].holds());
  EXPECT_FALSE(of_standard.plain[1].holds());
}

TEST(Compare, only_known_profiles_can_be_judged) {
  EXPECT_THROW(judged(kRight + "neither\n", "{}"), InputError);
}

TEST(Compare, settings_of_the_case_file_are_those_of_the_run) {
  const CaseComparison moon = judged("dy,2,1,-0.8,1e-9,r,s,both\n", R"({"set": {"both": {"gravity": "1.6"}}})");
  EXPECT_TRUE(moon.holds());
}

// s = g t²/2 - a t²/2 with a constant acceleration a = 1 upward.
TEST(Compare, a_file_that_a_setting_names_is_looked_for_in_the_case_folder) {
  const CaseFolder folder =
      free_fall("quantity,block,time,value,tolerance,tolerance_reason,source\ndy,2,1,-4.405,1e-9,r,s\n");
  support::write_text(folder.folder / "case.json", R"({"set": {"both": {"body_acceleration_file": "lift.csv"}}})");
  support::write_text(folder.folder / "lift.csv", "time,ax,ay\n0,0,1\n5,0,1\n");
  EXPECT_TRUE(compare_in(folder, {"legacy", "standard"}).holds());
  fs::remove(folder.folder / "lift.csv");
  EXPECT_THROW(compare_in(folder, {"legacy"}), InputError);
}

TEST(Compare, a_variant_is_held_against_the_same_values_with_its_own_settings) {
  const CaseComparison fall = judged(kRight + "both\n", R"({"variants": [
      {"name": "10 ms", "profile": "standard", "set": {"time_step": "0.01", "steps": "200"}},
      {"name": "moon", "profile": "standard", "set": {"gravity": "1.6"}},
      {"name": "far off", "profile": "legacy", "set": {"gravity": "9.8"}, "tolerance": 0.01, "reason": "9.8 for 9.81"}
      ]})");
  ASSERT_EQ(fall.variants.size(), 3U);
  EXPECT_EQ(fall.variants[0].outcome.steps, 200);
  EXPECT_TRUE(fall.variants[0].holds());
  EXPECT_NEAR(*fall.variants[1].values[0].computed, -0.8, 1e-9);
  EXPECT_FALSE(fall.variants[1].holds());
  EXPECT_TRUE(fall.variants[2].holds());
  EXPECT_FALSE(fall.holds());
}

TEST(Compare, a_variant_with_a_setting_that_is_none_leaves_the_other_runs) {
  const CaseComparison fall = judged(kRight + "both\n", R"({"variants": [
      {"name": "bad", "profile": "standard", "set": {"motion": "static", "load_steps": "0"}},
      {"name": "10 ms", "profile": "standard", "set": {"time_step": "0.01", "steps": "200"}}]})");
  EXPECT_TRUE(fall.plain[0].holds());
  EXPECT_NE(fall.variants[0].not_run.find("load_steps"), std::string::npos);
  EXPECT_FALSE(fall.variants[0].holds());
  EXPECT_TRUE(fall.variants[1].holds());
}

TEST(Compare, variants_of_a_profile_that_is_not_asked_for_are_not_run) {
  const CaseFolder folder =
      free_fall("quantity,block,time,value,tolerance,tolerance_reason,source\ndy,2,1,-4.905,1e-9,r,s\n");
  support::write_text(folder.folder / "case.json",
                      R"({"variants": [{"name": "n", "profile": "standard", "set": {}}]})");
  EXPECT_TRUE(compare_in(folder, {"legacy"}).variants.empty());
  EXPECT_EQ(compare_in(folder, {"standard"}).variants.size(), 1U);
}

TEST(Compare, a_profile_that_is_not_run_is_not_judged_and_says_why) {
  const CaseComparison fall =
      judged(kWrong + "legacy\n" + kRight + "both\n", R"({"legacy": "not run: it has no bolts"})");
  EXPECT_TRUE(fall.holds());
  EXPECT_EQ(fall.plain[0].not_run, "it has no bolts");
  EXPECT_FALSE(fall.plain[0].values[1].computed);
}

TEST(Compare, a_scene_that_cannot_be_run_misses_only_where_it_is_judged) {
  const CaseFolder folder =
      free_fall("quantity,block,time,value,tolerance,tolerance_reason,source,judged\n" + kRight + "standard\n");
  fs::copy_file(KEYBLOCK_SOURCE_DIR "/tests/malformed/08_no_closed_block_xml.geo", folder.inputs().front(),
                fs::copy_options::overwrite_existing);
  const CaseComparison none = compare_in(folder, {"legacy", "standard"});
  EXPECT_FALSE(none.plain[0].not_run.empty());
  EXPECT_TRUE(none.plain[0].holds());
  EXPECT_FALSE(none.plain[1].holds());
}

}  // namespace keyblock::study::compare_test
