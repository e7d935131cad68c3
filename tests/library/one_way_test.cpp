// The commands check, run, fos and sif say the same plan of a case as the library, and end as the library does.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <future>
#include <keyblock/keyblock.hpp>
#include <keyblock/studies.hpp>
#include <nlohmann/json.hpp>
#include <thread>

#include "api/case_file.hpp"
#include "api/case_folder.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::one_way_test {
namespace {

namespace kb = keyblock::api;

using Json = nlohmann::json;
using support::ProgramRun;
using support::run_keyblock;

/// Values of a plan that must agree.
struct Outline {
  std::string profile;
  std::string because;
  Json settings;
  int unknowns = 0;
};

/// Returns the plan as the report of `check` or the record of a run has it.
Outline outline_of(const Json& json, const char* requirements) {
  return {json.at("profile"), json.at("profile_because"), json.at("settings"), json.at(requirements).at("unknowns")};
}

/// Returns the plan as `fos` and `sif` have it, with the settings of the case that a search replaces put back.
Outline outline_of_study(const Json& json) {
  Outline outline{json.at("profile"), json.at("profile_because"), json.at("settings"), json.at("unknowns")};
  const Json replaced = json.value("settings_replaced", Json::object());
  for (const auto& [name, value] : replaced.items()) {
    EXPECT_TRUE(name == "motion" || name == "steps") << name;
    EXPECT_EQ(json.at("settings").at("motion"), "static");
    outline.settings[name] = value;
  }
  return outline;
}

/// Expects what the library has. A number is one in JSON; an infinite number is null.
void expect_settings(const std::vector<std::pair<std::string, std::string>>& settings, const Json& said) {
  EXPECT_EQ(said.size(), settings.size());
  for (const auto& [name, value] : settings) {
    const Json parsed = Json::parse(value, nullptr, false);
    const Json& found = said.at(name);
    EXPECT_EQ(found, found.is_string() ? Json(value) : parsed.is_discarded() ? Json() : parsed) << name;
  }
}

void expect_that_of(const kb::Plan& plan, const Outline& said) {
  EXPECT_EQ(said.profile, plan.profile());
  EXPECT_EQ(said.because, plan.why_profile());
  EXPECT_EQ(said.unknowns, plan.unknowns());
  expect_settings(plan.settings(), said.settings);
}

/// Expects the plan of a study of the library, with the settings of that study.
template <class Study>
void expect_that_of_study(const Study& found, const Json& said) {
  EXPECT_EQ(said.at("profile"), found.profile);
  EXPECT_EQ(said.at("profile_because"), found.why_profile);
  EXPECT_EQ(said.at("unknowns"), found.unknowns);
  expect_settings(found.settings, said.at("settings"));
}

std::vector<CaseFolder> cases() {
  return find_cases({std::string(KEYBLOCK_SOURCE_DIR) + "/legacy_cases"});
}

std::vector<CaseFolder> quick_cases() {
  std::vector<CaseFolder> chosen = cases();
  std::erase_if(chosen, [](const CaseFolder& folder) { return read_case_file(folder).is_slow; });
  return chosen;
}

/// Calls `look` with one case in so many, by their order; with each if KEYBLOCK_ALL_CASES is set, as `make validate`
/// sets it. Returns the number of calls.
int for_one_in(std::size_t few, const std::vector<CaseFolder>& all,
               const std::function<void(const std::string& folder)>& look) {
  if (std::getenv("KEYBLOCK_ALL_CASES") != nullptr) few = 1;
  int calls = 0;
  for (std::size_t i = 0; i < all.size(); i += few, ++calls) {
    SCOPED_TRACE(all[i].folder.string());
    look(all[i].folder.string());
  }
  return calls;
}

/// Plan of fos and sif: static, so that files that would take the rules of Shi's programs take `standard`.
void expect_plan_of_study(const std::string& folder, const ProgramRun& run) {
  const kb::Case of = kb::Case::read({folder});
  Outline said = outline_of_study(Json::parse(run.output));
  const kb::Plan own(of);
  if (own.profile() != "legacy") return expect_that_of(own, said);
  EXPECT_EQ(said.because, "the rules of Shi's programs cannot compute this");
  const kb::Plan asked(of, {.profile = "standard"});
  said.because = asked.why_profile();
  expect_that_of(asked, said);
}

/// Returns the exit code that the header promises; nothing for a stop.
std::optional<int> exit_code_of(kb::ErrorCode code) {
  switch (code) {
    case kb::ErrorCode::input:
      return 3;
    case kb::ErrorCode::choice:
      return 2;
    case kb::ErrorCode::stopped:
      return std::nullopt;
    default:
      return 4;
  }
}

/// Returns the exit code of the command that ends as `work` does; nothing if that takes longer than a second.
std::optional<int> code_within_a_second(const std::function<std::optional<int>(const kb::Context&)>& work) {
  const kb::Context context;
  std::promise<void> ended;
  std::jthread watch([&, over = ended.get_future()] {
    if (over.wait_for(std::chrono::seconds(1)) == std::future_status::timeout) context.stop();
  });
  std::optional<int> code;
  try {
    code = work(context);
  } catch (const kb::Error& error) {
    code = exit_code_of(error.code);
  }
  ended.set_value();
  return code;
}

/// Runs to the end of a case.
std::optional<int> code_of_run(const std::string& folder, const kb::Context& context) {
  kb::Run run(kb::Plan(kb::Case::read({folder}), {}, context));
  switch (run.go_on().end) {
    case kb::End::finished:
      return 0;
    case kb::End::doubtful:
      return 1;
    case kb::End::failed:
      return 4;
    default:
      return std::nullopt;
  }
}

}  // namespace

TEST(OneWay, check_says_the_plan_of_the_library) {
  const int checked = for_one_in(5, cases(), [](const std::string& folder) {
    const ProgramRun check = run_keyblock({"check", folder, "--json", "--trial", "0"});
    ASSERT_EQ(check.exit_code, 0) << check.messages;
    expect_that_of(kb::Plan(kb::Case::read({folder})), outline_of(Json::parse(check.output)["case"], "requires"));
  });
  EXPECT_GE(checked, 60);
}

TEST(OneWay, run_records_the_plan_of_the_library) {
  const std::string out = support::fresh_folder("one_way_run") + "/out";
  const int run = for_one_in(13, quick_cases(), [&](const std::string& folder) {
    const ProgramRun made = run_keyblock({"run", folder, "-o", out, "--force", "--set", "steps=1", "--json"});
    const Json record = Json::parse(made.output, nullptr, false);
    ASSERT_FALSE(record.is_discarded()) << made.messages;
    expect_that_of(kb::Plan(kb::Case::read({folder}), {.set = {{"steps", "1"}}}), outline_of(record, "requirements"));
  });
  EXPECT_GE(run, 15);
}

TEST(OneWay, fos_says_the_plan_of_the_library) {
  int planned = 0;
  for_one_in(5, cases(), [&](const std::string& folder) {
    const ProgramRun fos = run_keyblock({"fos", folder, "--plan"});
    if (fos.exit_code == 0) {
      ++planned;
      const kb::Context stopped;
      stopped.stop();  // before the first trial
      const kb::Strength found = kb::factor_of_safety(kb::Case::read({folder}), {}, 0, {}, stopped);
      EXPECT_EQ(found.end, "stopped");
      expect_that_of_study(found, Json::parse(fos.output));
      return expect_plan_of_study(folder, fos);
    }
    EXPECT_EQ(fos.exit_code, code_within_a_second([&](const kb::Context& context) -> std::optional<int> {
                kb::factor_of_safety(kb::Case::read({folder}), {}, 0, {}, context);
                return 0;
              }))
        << fos.messages;
  });
  EXPECT_GE(planned, 20);
}

TEST(OneWay, sif_says_the_plan_of_the_library) {
  int planned = 0;
  for_one_in(5, cases(), [&](const std::string& folder) {
    const ProgramRun sif = run_keyblock({"sif", folder, "--plan"});
    if (sif.exit_code == 0) {
      ++planned;
      return expect_plan_of_study(folder, sif);
    }
    EXPECT_EQ(sif.exit_code, code_within_a_second([&](const kb::Context& context) -> std::optional<int> {
                kb::stress_intensity(kb::Case::read({folder}), {}, context);
                return 0;
              }))
        << sif.messages;
  });
  EXPECT_GE(planned, 8);
}

TEST(OneWay, a_run_of_the_library_and_one_of_the_command_end_alike) {
  const std::string results = support::fresh_folder("one_way");
  int compared = 0;
  const int chosen = for_one_in(13, quick_cases(), [&](const std::string& folder) {
    const std::optional<int> code =
        code_within_a_second([&](const kb::Context& context) { return code_of_run(folder, context); });
    if (!code) return;
    const ProgramRun run = run_keyblock({"run", folder, "-o", results + "/out", "--force", "--threads", "1"});
    EXPECT_EQ(run.exit_code, *code) << run.messages;
    ++compared;
  });
  EXPECT_GE(compared, chosen / 3);
}

TEST(OneWay, fos_of_the_library_and_the_command_end_alike) {
  int bracketed = 0;
  for_one_in(13, quick_cases(), [&](const std::string& folder) {
    kb::Strength found;
    const std::optional<int> code = code_within_a_second([&](const kb::Context& context) -> std::optional<int> {
      found = kb::factor_of_safety(kb::Case::read({folder}), {}, 0, {}, context);
      if (found.end == "stopped") return std::nullopt;
      return found.end == "bracketed" && *found.stands >= 1 ? 0 : 1;
    });
    if (!code) return;
    const ProgramRun fos = run_keyblock({"fos", folder, "--json", "--no-mesh-error"});
    EXPECT_EQ(fos.exit_code, *code) << fos.messages;
    if (found.end != "bracketed") return;
    const Json said = Json::parse(fos.output);
    expect_that_of_study(found, said);
    const Json& bracket = said.at("bracket");
    EXPECT_EQ(bracket.at("stands"), *found.stands);
    EXPECT_EQ(bracket.at("falls"), *found.falls);
    ++bracketed;
  });
  EXPECT_GE(bracketed, 2);
}

TEST(OneWay, sif_of_the_library_and_the_command_end_alike) {
  int with_tips = 0;
  for_one_in(7, quick_cases(), [&](const std::string& folder) {
    kb::Intensity found;
    const std::optional<int> code = code_within_a_second([&](const kb::Context& context) -> std::optional<int> {
      found = kb::stress_intensity(kb::Case::read({folder}), {}, context);
      return std::ranges::all_of(found.tips, [](const kb::Tip& tip) { return tip.doubt.empty(); }) ? 0 : 1;
    });
    if (!code) return;
    const ProgramRun sif = run_keyblock({"sif", folder, "--json"});
    EXPECT_EQ(sif.exit_code, *code) << sif.messages;
    if (found.tips.empty()) return;
    const Json said = Json::parse(sif.output);
    EXPECT_EQ(said.at("tips").size(), found.tips.size());
    expect_that_of_study(found, said);
    ++with_tips;
  });
  EXPECT_GE(with_tips, 1);
}

TEST(OneWay, what_nothing_fixes_is_refused_before_any_trial) {
  const std::string file = support::fresh_folder("one_way_loose") + "/slope.json";
  run_keyblock({"new", "slope", "-o", file});
  std::string text = support::read_text(file);
  const std::size_t from = text.find("\"fixed_lines\"");
  text.erase(from, text.find('\n', from) - from);
  support::write_text(file, text);
  const ProgramRun fos = run_keyblock({"fos", file});
  EXPECT_EQ(fos.exit_code, 4);
  try {
    kb::factor_of_safety(kb::Case::read({file}));
    ADD_FAILURE() << "the library searches";
  } catch (const kb::Error& error) {
    EXPECT_NE(fos.messages.find(error.what()), std::string::npos) << error.what() << "\n" << fos.messages;
  }
}

}  // namespace keyblock::one_way_test
