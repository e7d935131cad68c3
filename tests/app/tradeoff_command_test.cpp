// `tradeoff` and `sweep` from the command line: exit codes, files written and never overwritten, stable JSON.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::tradeoff_command_test {
namespace {

using support::fresh_folder;
using support::ProgramRun;
using support::read_text;
using support::run_keyblock;
using Json = nlohmann::ordered_json;

const std::string kFall = KEYBLOCK_SOURCE_DIR "/legacy_cases/free_fall/released";
const std::string kSlide = KEYBLOCK_SOURCE_DIR "/legacy_cases/sliding_block/a30_p20";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::vector<std::string> keys_of(const Json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

}  // namespace

TEST(TradeoffCommand, refuses_numbers_that_are_none_in_plain_words) {
  for (const auto& [option, value] :
       {std::pair{"--error", "0"}, {"--error", "-1"}, {"--error", "x"}, {"--limit", "inf"}}) {
    const ProgramRun run = run_keyblock({"tradeoff", kFall, option, value});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_TRUE(contains(run.messages, std::string("expected a number above 0, found \"") + value)) << run.messages;
  }
}

TEST(TradeoffCommand, picks_settings_that_run_takes) {
  const std::string folder = fresh_folder("tradeoff");
  const std::string file = folder + "/wish.settings";
  const std::string picture = folder + "/front.svg";
  const std::vector<std::string> command{"tradeoff", kFall,       "--error", "1e-3",  "-o",
                                         file,       "--picture", picture,   "--json"};
  const ProgramRun made = run_keyblock(command);
  ASSERT_EQ(made.exit_code, 0) << made.messages;
  const Json json = Json::parse(made.output);
  EXPECT_EQ(keys_of(json), (std::vector<std::string>{"case", "common", "reference", "machine", "runs", "front", "wish",
                                                     "choice", "settings_file"}));
  EXPECT_EQ(keys_of(json["runs"][0]),
            (std::vector<std::string>{"name", "group", "profile", "set", "end", "reason", "steps", "unknowns",
                                      "cpu_seconds", "timings", "error", "error_bound", "on_front", "over_front"}));
  EXPECT_TRUE(contains(read_text(picture), "</svg>"));
  EXPECT_TRUE(contains(read_text(file), "profile = "));
  const ProgramRun run = run_keyblock(
      {"run", kFall + "/released.geo", kFall + "/released.ana", "--settings-file", file, "-o", folder + "/out"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  const ProgramRun again = run_keyblock(command);
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_TRUE(contains(again.messages, "wish.settings exists")) << again.messages;
  EXPECT_TRUE(again.output.empty());
}

TEST(TradeoffCommand, a_wish_that_no_run_meets_is_exit_1_and_writes_nothing) {
  const std::string file = fresh_folder("unmet") + "/wish.settings";
  const ProgramRun made = run_keyblock({"tradeoff", kFall, "--vary", "step", "--error", "1e-30", "-o", file});
  EXPECT_EQ(made.exit_code, 1);
  EXPECT_TRUE(contains(made.messages, "no run meets an error of at most 1e-30; the most accurate is")) << made.messages;
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_TRUE(contains(made.output, "over front"));
}

TEST(TradeoffCommand, wrong_usage_is_exit_2_before_any_run) {
  const std::string folder = fresh_folder("tradeoff_usage");
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--budget", "soon"},
                                               {"--budget", "-1s"},
                                               {"--set", "basis"},
                                               {"--set", "basis=soft"},
                                               {"--finest", "12"},
                                               {"--vary", "colour"},
                                               {"-o", folder + "/a.settings"},
                                               {"--error", "0"},
                                               {"--picture", folder + "/none/a.svg"}}) {
    std::vector<std::string> command{"tradeoff", kFall};
    command.insert(command.end(), more.begin(), more.end());
    const ProgramRun made = run_keyblock(command);
    EXPECT_EQ(made.exit_code, 2) << more[0] << " " << more[1] << made.messages;
    EXPECT_TRUE(made.output.empty()) << more[0];
  }
  EXPECT_EQ(run_keyblock({"tradeoff"}).exit_code, 2);
}

TEST(TradeoffCommand, input_that_cannot_be_used_is_exit_3) {
  EXPECT_EQ(run_keyblock({"tradeoff", KEYBLOCK_SOURCE_DIR "/legacy_cases/free_fall"}).exit_code, 3);
  EXPECT_EQ(run_keyblock({"tradeoff", fresh_folder("no_case")}).exit_code, 3);
}

// A sliding block: its steps are exact, so that refinement changes nothing.
TEST(TradeoffCommand, files_without_expected_values_are_held_against_their_own_limit) {
  const ProgramRun made = run_keyblock({"tradeoff", kSlide + "/a30_p20.geo", kSlide + "/a30_p20.ana", "--json",
                                        "--vary", "step", "--finest", "8", "--set", "steps=200"});
  ASSERT_EQ(made.exit_code, 0) << made.messages;
  const Json json = Json::parse(made.output);
  EXPECT_EQ(json["reference"]["kind"], "finest");
  EXPECT_LT(json["reference"]["uncertainty"].get<double>(), 1e-6);
  EXPECT_TRUE(contains(json["reference"]["words"], "step /8"));
}

TEST(TradeoffMap, writes_map_table_and_picture) {
  const std::string folder = fresh_folder("tradeoff_map");
  const std::vector<std::string> command{"tradeoff",          kSlide,  "--map",   "--penalties",       "10,1",
                                         "--steps",           "8,4",   "--table", folder + "/map.csv", "--picture",
                                         folder + "/map.svg", "--json"};
  const ProgramRun made = run_keyblock(command);
  ASSERT_EQ(made.exit_code, 0) << made.messages;
  const Json json = Json::parse(made.output);
  EXPECT_EQ(keys_of(json), (std::vector<std::string>{"case", "reference", "machine", "cells"}));
  ASSERT_EQ(json["cells"].size(), 4U);
  EXPECT_EQ(keys_of(json["cells"][0]), (std::vector<std::string>{"penalty_factor", "step_factor", "set", "verdict",
                                                                 "reason", "steps", "error", "cpu_seconds"}));
  EXPECT_EQ(json["cells"][1]["step_factor"], 4);
  EXPECT_TRUE(contains(read_text(folder + "/map.csv"), "penalty_factor,contact_penalty,step_factor"));
  EXPECT_TRUE(contains(read_text(folder + "/map.svg"), "</svg>"));
  EXPECT_EQ(run_keyblock(command).exit_code, 2);
}

TEST(TradeoffMap, cells_over_the_limit_say_so_and_a_map_of_nothing_else_is_exit_4) {
  const ProgramRun made =
      run_keyblock({"tradeoff", kSlide, "--map", "--penalties", "1", "--steps", "1", "--limit", "0.0001"});
  EXPECT_EQ(made.exit_code, 4);
  EXPECT_TRUE(contains(made.output, "over limit")) << made.output;
}

TEST(TradeoffMap, its_options_need_it_and_it_excludes_others) {
  EXPECT_EQ(run_keyblock({"tradeoff", kSlide, "--steps", "1"}).exit_code, 2);
  EXPECT_EQ(run_keyblock({"tradeoff", kSlide, "--map", "--budget", "1s"}).exit_code, 2);
  const ProgramRun former = run_keyblock({"sweep", kSlide});
  EXPECT_EQ(former.exit_code, 2);
  EXPECT_TRUE(contains(former.messages, "keyblock tradeoff --map")) << former.messages;
}

TEST(TradeoffMap, a_case_without_contact_steps_is_exit_2) {
  EXPECT_EQ(run_keyblock({"tradeoff", KEYBLOCK_SOURCE_DIR "/legacy_cases/cook_membrane/coarse", "--map"}).exit_code, 2);
}

TEST(RunCommand, a_settings_file_is_overruled_by_the_command_line_and_its_faults_are_exit_3) {
  const std::string folder = fresh_folder("settings_file");
  support::write_text(folder + "/a.settings", "profile = legacy\nsteps = 30\ntime_step = 1e-3\n");
  support::write_text(folder + "/b.settings", "steps = none\n");
  const std::vector<std::string> run{"run", kSlide + "/a30_p20.geo", kSlide + "/a30_p20.ana",
                                     "-o",  folder + "/out",         "--settings-file"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), run.begin(), run.end());
    return run_keyblock(more);
  };
  ASSERT_EQ(with({folder + "/a.settings", "--set", "steps=20"}).exit_code, 0);
  const Json record = Json::parse(read_text(folder + "/out/run.json"));
  EXPECT_EQ(record["profile"], "legacy");
  EXPECT_EQ(record["settings"]["steps"], 20);
  EXPECT_EQ(record["settings"]["time_step"], 1e-3);
  const ProgramRun wrong = with({folder + "/b.settings", "--force"});
  EXPECT_EQ(wrong.exit_code, 3);
  EXPECT_TRUE(contains(wrong.messages, "b.settings:1:9: error: setting steps: expected")) << wrong.messages;
  EXPECT_EQ(with({folder + "/none.settings", "--force"}).exit_code, 3);
}

}  // namespace keyblock::tradeoff_command_test
