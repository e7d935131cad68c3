// Messages of a run by level: warnings with their remedies, notes in one line, bookkeeping in the record only.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/words/diagnostics.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::levels_of_warnings_test {
namespace {

using support::fresh_folder;
using support::run_keyblock;
using support::run_script;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// Two lines of a drawing that cover each other, which is a note, in a case with `more` in its analysis.
std::string square(const std::string& more) {
  return R"({"keyblock": 2, "units": {"length": "m", "mass": "kg", "time": "s"},
 "drawing": {"joints": [[0, 0, 1, 0, 1], [1, 0, 1, 1, 1], [1, 1, 0, 1, 1], [0, 1, 0, 0, 1], [0, 0, 0.5, 0, 1]],
             "fixed_lines": [[0.2, 0.2, 0.2, 0.2], [0.8, 0.2, 0.8, 0.2]]},
 "analysis": {"step_count": 2, "time_step": 1e-3, "block_materials": [{"like": "sandstone"}],
              "joint_materials": [{"friction_angle_deg": 30}])" +
         more + "}}";
}

}  // namespace

// A name stands for its case file, and the results lie in `out`.
TEST(LevelsOfWarnings, templates_run_without_a_warning) {
  for (const char* kind : {"slope", "arch", "beam", "tunnel", "block"}) {
    const std::string folder = fresh_folder(fmt::format("levels_{}", kind));
    const auto run = run_script(fmt::format("cd {} && \"$K\" new {} && \"$K\" run {}", folder, kind, kind));
    EXPECT_EQ(run.exit_code, 0) << kind << run.messages;
    EXPECT_TRUE(contains(support::read_text(folder + "/out/run.json"), "\"finished\"")) << kind;
    EXPECT_FALSE(contains(run.messages, "warning:")) << run.messages;
    EXPECT_LE(count_of(run.messages, "--verbose shows"), 1U) << run.messages;
    EXPECT_EQ(count_of(run.messages, "\n  motion    "), 1U) << run.messages;
    EXPECT_EQ(run_script(fmt::format("cd {} && \"$K\" run {}", folder, kind)).exit_code, 2) << "out exists";
  }
}

TEST(LevelsOfWarnings, notes_are_one_line_with_their_codes_and_verbose_has_their_sentences) {
  const std::string folder = fresh_folder("levels_notes");
  support::write_text(folder + "/case.json", square(""));
  const auto run = run_keyblock({"run", folder + "/case.json", "-o", folder + "/out"});
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_TRUE(contains(run.messages, "notes on the case: defaults_taken, overlapping_lines")) << run.messages;
  EXPECT_FALSE(contains(run.messages, "defaults taken: ")) << run.messages;
  const auto record = nlohmann::json::parse(support::read_text(folder + "/out/run.json"));
  EXPECT_TRUE(contains(record["warnings"].dump(), "overlapping_lines"));
  const auto verbose = run_keyblock({"run", folder + "/case.json", "-o", folder + "/two", "--verbose"});
  EXPECT_TRUE(contains(verbose.messages, "defaults taken: ")) << verbose.messages;
  EXPECT_TRUE(contains(run_keyblock({"check", folder + "/case.json"}).output, "defaults taken: "));
}

TEST(LevelsOfWarnings, a_remedy_follows_the_warnings_of_its_code_once_and_notes_have_none) {
  const std::string folder = fresh_folder("levels_help");
  support::write_text(folder + "/case.json", square(""));
  std::vector<std::string> arguments{"run",   folder + "/case.json",     "-o",    folder + "/out",
                                     "--set", "elastic_law=logarithmic", "--set", "path_step=2"};
  const std::string help = "  help: remove the setting; `keyblock run --settings` lists what reads each\n";
  const auto run = run_keyblock(arguments);
  ASSERT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_EQ(count_of(run.messages, "[setting_without_effect]"), 1U) << run.messages;
  EXPECT_EQ(count_of(run.messages, help), 1U) << run.messages;
  EXPECT_TRUE(contains(run.messages, "[setting_without_effect] (and 1 more like this)\n" + help)) << run.messages;
  EXPECT_EQ(count_of(run.messages, "  help: "), 1U) << run.messages;
  arguments[3] = folder + "/two";
  arguments.emplace_back("--verbose");
  const auto verbose = run_keyblock(arguments);
  EXPECT_EQ(count_of(verbose.messages, "[setting_without_effect]\n"), 2U) << verbose.messages;
  EXPECT_EQ(count_of(verbose.messages, help), 1U) << verbose.messages;
  EXPECT_TRUE(contains(verbose.messages, "[defaults_taken]\n")) << verbose.messages;
  EXPECT_FALSE(contains(verbose.messages, std::string(find_diagnostic("defaults_taken")->remedy))) << verbose.messages;
  EXPECT_FALSE(contains(run_keyblock({"run", folder + "/case.json", "-o", folder + "/three", "--quiet", "--set",
                                      "elastic_law=logarithmic"})
                            .messages,
                        "help"));
}

TEST(LevelsOfWarnings, check_prints_each_code_once_with_its_remedy_and_json_has_all) {
  const std::string file = fresh_folder("levels_check") + "/case.json";
  support::write_text(file, square(""));
  std::vector<std::string> arguments{"check", file,         "--trial", "0", "--set", "elastic_law=logarithmic",
                                     "--set", "path_step=2"};
  const auto check = run_keyblock(arguments);
  const std::string help = "    help: remove the setting; `keyblock run --settings` lists what reads each\n";
  EXPECT_TRUE(contains(check.output, "[setting_without_effect] (and 1 more like this)\n" + help)) << check.output;
  EXPECT_EQ(count_of(check.output, "help:"), 1U) << check.output;
  arguments.emplace_back("--json");
  const auto json = nlohmann::json::parse(run_keyblock(arguments).output);
  EXPECT_EQ(count_of(json["case"]["warnings"].dump(), "setting_without_effect"), 2U) << json;
}

TEST(LevelsOfWarnings, explain_lists_every_code_and_explains_each) {
  const auto list = run_keyblock({"explain"});
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_EQ(count_of(list.output, "\n"), diagnostics().size());
  for (const Diagnostic& row : diagnostics()) {
    const std::string line = fmt::format("{:<8} {}\n", word_of(row.level), row.summary);
    EXPECT_TRUE(contains(list.output, std::string(row.code) + ' ')) << row.code;
    EXPECT_TRUE(contains(list.output, line)) << row.code;
  }
  const auto one = run_keyblock({"explain", "[start_settled]"});
  EXPECT_EQ(one.exit_code, 0);
  EXPECT_TRUE(contains(one.output, "start_settled (note): ")) << one.output;
  const auto wrong = run_keyblock({"explain", "start_setled"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_TRUE(contains(wrong.messages, "did you mean \"start_settled\"?")) << wrong.messages;
}

TEST(LevelsOfWarnings, each_code_has_one) {
  EXPECT_EQ(level_of("energy_beyond_limit"), DiagnosticLevel::error);
  EXPECT_EQ(level_of("unheld_blocks"), DiagnosticLevel::warning);
  EXPECT_EQ(level_of("start_settled"), DiagnosticLevel::note);
  EXPECT_EQ(level_of("nodes_merged"), DiagnosticLevel::silent);
  EXPECT_EQ(level_of("stage_not_balanced"), DiagnosticLevel::error);
  EXPECT_EQ(level_of("no_such_code"), DiagnosticLevel::warning);
}

}  // namespace keyblock::levels_of_warnings_test
