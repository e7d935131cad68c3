// Commands, studies and the library get the same plan of a case, and a run ends alike.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <keyblock/keyblock.hpp>
#include <nlohmann/json.hpp>

#include "api/plan.hpp"
#include "settings/profile.hpp"
#include "settings/settings_table.hpp"
#include "tests/support/program.hpp"

namespace keyblock::one_way_test {
namespace {

namespace kb = keyblock::api;

using Json = nlohmann::json;
using SettingList = std::vector<std::pair<std::string, std::string>>;

/// Values that must agree.
struct Outline {
  std::string profile;
  SettingList settings;
  int unknowns = 0;

  bool operator==(const Outline&) const = default;
};

Outline outline_of(const std::string& profile, const Prepared& prepared) {
  Outline outline{profile, {}, prepared.requirements.unknowns};
  for (const SettingText& setting : list(prepared.scene.settings))
    outline.settings.emplace_back(setting.name, setting.value);
  return outline;
}

Outline outline_of(const kb::Plan& plan) {
  return {plan.profile(), plan.settings(), plan.unknowns()};
}

/// Expects a setting of the report of `check`: a number as one, an infinite number as null.
void expect_same(const Json& checked, const std::string& name, const std::string& value) {
  const Json parsed = Json::parse(value, nullptr, false);
  EXPECT_EQ(checked.at(name), checked.at(name).is_string() ? Json(value)
                              : parsed.is_discarded()      ? Json()
                                                           : parsed)
      << name;
}

std::vector<CaseFolder> cases() {
  return find_cases({std::string(KEYBLOCK_SOURCE_DIR) + "/legacy_cases"});
}

std::vector<CaseFolder> quick_cases() {
  std::vector<CaseFolder> chosen = cases();
  std::erase_if(chosen, [](const CaseFolder& folder) { return read_case_file(folder).is_slow; });
  return chosen;
}

// Takes every case if KEYBLOCK_ALL_CASES is set, as `make validate` sets it.
std::size_t one_in(std::size_t few) {
  return std::getenv("KEYBLOCK_ALL_CASES") != nullptr ? 1 : few;
}

/// Returns the exit code that `keyblock run` gives to this end.
int code_of(kb::End end) {
  return end == kb::End::finished ? 0 : end == kb::End::doubtful ? 1 : 4;
}

/// Runs to the end; returns nothing if that takes longer than a second.
std::optional<int> code_of_run(const kb::Plan& plan) {
  const auto begin = std::chrono::steady_clock::now();
  kb::Run run(plan);
  const kb::Outcome& outcome =
      run.go_on([&](const kb::Run&) { return std::chrono::steady_clock::now() - begin > std::chrono::seconds(1); });
  if (outcome.end == kb::End::running) return std::nullopt;
  return code_of(outcome.end);
}

}  // namespace

TEST(OneWay, run_check_fos_sif_comparison_and_library_make_the_same_plan_of_a_case) {
  const std::vector<CaseFolder> all = cases();
  ASSERT_GT(all.size(), 320U);
  for (std::size_t i = 0; i < all.size(); i += one_in(3)) {
    const std::string folder = all[i].folder.string();
    SCOPED_TRACE(folder);
    const OpenCase open = opened(asked_case({{folder}, {}, {}, {}}));
    const Problem& problem = open.input.problem;
    const PlannedCase plan = planned(open, problem);
    const Outline of_run = outline_of(plan.profile.name, plan.prepared);
    EXPECT_EQ(of_run, outline_of(kb::Plan(kb::Case::read({folder}))));
    EXPECT_EQ(of_run, outline_of(plan.profile.name, prepared_case(configured_under(plan.profile.name, open, problem))))
        << "of a comparison";
    const ConfiguredCase of_statics = configured(open, problem, OldFiles::standard);
    if (of_statics.profile.name == plan.profile.name) {
      EXPECT_EQ(of_run, outline_of(of_statics.profile.name, prepared_case(of_statics))) << "of fos and sif";
    } else {
      EXPECT_EQ(plan.profile.name, "legacy");
      EXPECT_EQ(of_statics.profile.name, "standard");
    }
  }
}

TEST(OneWay, check_prints_the_plan_of_the_library) {
  const std::vector<CaseFolder> all = cases();
  for (std::size_t i = 0; i < all.size(); i += one_in(7)) {
    const std::string folder = all[i].folder.string();
    SCOPED_TRACE(folder);
    const support::ProgramRun check = support::run_keyblock({"check", folder, "--json", "--trial", "0"});
    ASSERT_EQ(check.exit_code, 0) << check.messages;
    const Json report = Json::parse(check.output)["case"];
    const kb::Plan plan(kb::Case::read({folder}));
    EXPECT_EQ(report["profile"], plan.profile());
    EXPECT_EQ(report["profile_because"], plan.why_profile());
    EXPECT_EQ(report["requires"]["unknowns"], plan.unknowns());
    EXPECT_EQ(report["settings"].size(), plan.settings().size());
    for (const auto& [name, value] : plan.settings()) expect_same(report["settings"], name, value);
  }
}

TEST(OneWay, a_run_of_the_library_and_one_of_the_command_end_alike) {
  const std::vector<CaseFolder> all = quick_cases();
  const std::string results = support::fresh_folder("one_way");
  int compared = 0, chosen = 0;
  for (std::size_t i = 0; i < all.size(); i += one_in(13), ++chosen) {
    const std::string folder = all[i].folder.string();
    SCOPED_TRACE(folder);
    const std::optional<int> code = code_of_run(kb::Plan(kb::Case::read({folder})));
    if (!code) continue;
    const support::ProgramRun run =
        support::run_keyblock({"run", folder, "-o", results + "/" + std::to_string(i), "--threads", "1"});
    EXPECT_EQ(run.exit_code, *code) << run.messages;
    ++compared;
  }
  EXPECT_GE(compared, chosen / 3);
}

}  // namespace keyblock::one_way_test
