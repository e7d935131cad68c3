// `keyblock convert` from the command line: names of outputs; files refused, kept and reported.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::convert_command_test {
namespace {

using support::fresh_folder;
using support::ProgramRun;
using support::read_text;
using support::run_keyblock;
using support::write_text;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// A triangle with two material lines, and an analysis with an initial velocity.
const std::string kLines =
    "0.001\n3 0\n2\n0\n1\n0\n0\n0\n0 0 2 0 1\n2 0 1 2 1\n1 2 0 0 1\n0.9 0.5 1.1 0.5 1\n0.9 0.6 1.1 0.6 1\n1 0.2 1 "
    "0.2\n";
const std::string kControls = "1\n10\n1\n1\n0.01\n0.1\n2 20 1e6 0.2\n0 0 0\n0 0 0\n1 0 0\n30 0 0\n";

class ConvertCommand : public ::testing::Test {
 protected:
  ConvertCommand() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fresh_folder(std::string("convert_") + test->name()) + "/";
    write_text(folder_ + "a.geo", kLines);
    write_text(folder_ + "a.ana", kControls);
  }

  ProgramRun convert(std::vector<std::string> more) const {
    more.insert(more.begin(), {"convert", folder_ + "a.geo", folder_ + "a.ana"});
    return run_keyblock(more);
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ + name); }

  std::string folder_;
};

}  // namespace

TEST_F(ConvertCommand, two_files_have_the_endings_behind_the_whole_name) {
  EXPECT_EQ(convert({"-o", folder_ + "slope1.5", "--to", "berkeley"}).exit_code, 0);
  EXPECT_TRUE(exists("slope1.5.geo") && exists("slope1.5.ana"));
  EXPECT_EQ(convert({"-o", folder_ + "b.ana", "--to", "berkeley"}).exit_code, 0);
  EXPECT_TRUE(exists("b.geo") && exists("b.ana")) << "an ending of the target is replaced";
}

TEST_F(ConvertCommand, strict_writes_nothing_where_the_target_cannot_hold_all) {
  const ProgramRun loose = convert({"-o", folder_ + "loose.csv"});
  EXPECT_EQ(loose.exit_code, 0);
  EXPECT_TRUE(contains(loose.output, "lost: analysis: {dialect, velocity_carry_over, ")) << loose.output;
  const ProgramRun strict = convert({"-o", folder_ + "strict.csv", "--strict"});
  EXPECT_EQ(strict.exit_code, 1);
  EXPECT_TRUE(contains(strict.messages, "csv cannot hold all")) << strict.messages;
  EXPECT_FALSE(exists("strict.csv"));
  EXPECT_EQ(convert({"-o", folder_ + "whole.json", "--strict"}).exit_code, 0);
  EXPECT_TRUE(exists("whole.json"));
}

TEST_F(ConvertCommand, what_is_overwritten_by_force_is_kept) {
  write_text(folder_ + "b.json", "first");
  EXPECT_EQ(convert({"-o", folder_ + "b.json"}).exit_code, 2);
  EXPECT_EQ(read_text(folder_ + "b.json"), "first");
  EXPECT_EQ(convert({"-o", folder_ + "b.json", "--force"}).exit_code, 0);
  EXPECT_EQ(read_text(folder_ + "b.json.bak"), "first");
  EXPECT_EQ(convert({"-o", folder_ + "b.json", "--force"}).exit_code, 0);
  EXPECT_EQ(read_text(folder_ + "b.json.bak"), "first");
  EXPECT_EQ(read_text(folder_ + "b.json.bak2"), read_text(folder_ + "b.json"));
  EXPECT_EQ(convert({"-o", folder_ + "a.geo", "--force", "--to", "dda-geometry"}).exit_code, 2) << "an input";
}

TEST_F(ConvertCommand, faults_of_the_old_program_are_taken_on_request) {
  ASSERT_EQ(convert({"-o", folder_ + "faulty", "--to", "berkeley", "--bug-compatible"}).exit_code, 0);
  EXPECT_TRUE(contains(read_text(folder_ + "faulty.geo"), "3 0\n1\n")) << "one material line left";
  EXPECT_FALSE(contains(read_text(folder_ + "faulty.ana"), "\n1 0 0\n")) << "the velocity is that of the gradient";
  ASSERT_EQ(convert({"-o", folder_ + "sound", "--to", "berkeley"}).exit_code, 0);
  EXPECT_EQ(read_text(folder_ + "sound.geo"), kLines);
  EXPECT_EQ(read_text(folder_ + "sound.ana"), kControls);
}

TEST_F(ConvertCommand, a_file_that_settings_name_is_named_from_the_new_folder) {
  const auto convert_to = [&](const std::string& from, const std::string& to) {
    EXPECT_EQ(run_keyblock({"convert", folder_ + from, "-o", folder_ + to}).exit_code, 0);
    return read_text(folder_ + to);
  };
  ASSERT_EQ(convert({"-o", folder_ + "own.json"}).exit_code, 0);
  auto with_table = nlohmann::json::parse(read_text(folder_ + "own.json"));
  with_table["run"]["set"]["body_acceleration_file"] = "acc.csv";
  write_text(folder_ + "with.json", with_table.dump());
  std::filesystem::create_directories(folder_ + "deep/below");
  EXPECT_TRUE(contains(convert_to("with.json", "deep/below/moved.json"), "\"../../acc.csv\""));
  EXPECT_TRUE(contains(convert_to("deep/below/moved.json", "back.json"), "\"acc.csv\""));
  EXPECT_EQ(convert_to("with.json", "same.json"), with_table.dump());
}

TEST_F(ConvertCommand, json_names_outputs_losses_and_warnings) {
  const ProgramRun run = convert({"-o", folder_ + "b.dxf", "--json"});
  ASSERT_EQ(run.exit_code, 0);
  const auto json = nlohmann::json::parse(run.output);
  EXPECT_EQ(json["outputs"], nlohmann::json::array({folder_ + "b.dxf"}));
  ASSERT_EQ(json["losses"].size(), 1U);
  EXPECT_EQ(json["losses"][0]["item"], "analysis");
  EXPECT_TRUE(contains(json["losses"][0]["change"], "step_count")) << json["losses"][0];
  EXPECT_TRUE(json["warnings"].empty());
}

TEST_F(ConvertCommand, a_file_of_the_target_that_is_not_written_is_named) {
  const ProgramRun run = convert({"-o", folder_ + "m", "--to", "manifold"});
  ASSERT_EQ(run.exit_code, 0);
  EXPECT_TRUE(contains(run.output, folder_ + "m.mf\nnot written: " + folder_ + "m.cv: a cover file needs a cover"))
      << run.output;
  const ProgramRun json = convert({"-o", folder_ + "n", "--to", "manifold", "--json"});
  EXPECT_EQ(nlohmann::json::parse(json.output)["not_written"].size(), 1U);
  const ProgramRun both = convert({"-o", folder_ + "shi", "--to", "shi", "--json"});
  EXPECT_TRUE(nlohmann::json::parse(both.output)["not_written"].empty());
}

TEST_F(ConvertCommand, a_profile_that_changes_is_told) {
  const ProgramRun own = convert({"-o", folder_ + "own.json"});
  EXPECT_EQ(own.exit_code, 0);
  EXPECT_TRUE(contains(own.messages,
                       "without --profile, a run takes profile standard for the written files and legacy for those "
                       "read: --profile legacy keeps to that [profile_changes]"))
      << own.messages;
  const ProgramRun back = run_keyblock({"convert", folder_ + "own.json", "-o", folder_ + "back", "--to", "berkeley"});
  EXPECT_EQ(back.exit_code, 0);
  EXPECT_TRUE(contains(back.messages, "profile legacy for the written files and standard for those read"))
      << back.messages;
  std::string named = read_text(folder_ + "own.json");
  named.insert(named.find('{') + 1, R"("run": {"profile": "legacy"},)");
  write_text(folder_ + "named.json", named);
  for (const ProgramRun& same :
       {run_keyblock({"convert", folder_ + "named.json", "-o", folder_ + "named", "--to", "berkeley"}),
        convert({"-o", folder_ + "same", "--to", "berkeley"}), convert({"-o", folder_ + "lines.dxf"})})
    EXPECT_FALSE(contains(same.messages, "_changes]")) << same.messages;
}

TEST_F(ConvertCommand, rules_of_legacy_that_change_with_the_dialect_are_told) {
  const ProgramRun run = convert({"-o", folder_ + "shi", "--to", "shi", "--json"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(contains(run.messages, "profile legacy has other rules for the written dialect: ")) << run.messages;
  EXPECT_TRUE(contains(run.messages, "quirk.weight_of_first_material = off, before on")) << run.messages;
  const auto json = nlohmann::json::parse(run.output);
  EXPECT_EQ(json["changed_rules"][0]["name"], "dialect_changes");
  EXPECT_TRUE(json["warnings"].empty());
}

TEST_F(ConvertCommand, wrong_usage_and_bad_input_have_their_exit_codes) {
  EXPECT_EQ(convert({}).exit_code, 2) << "no output";
  EXPECT_EQ(convert({"-o", folder_ + "b.unknown"}).exit_code, 2) << "an ending of no target";
  EXPECT_EQ(convert({"-o", folder_ + "b", "--to", "tex"}).exit_code, 2);
  std::string damaged = kLines;
  write_text(folder_ + "a.geo", damaged.replace(damaged.find("0.5 1.1"), 3, "o.5"));
  const ProgramRun run = convert({"-o", folder_ + "b.json"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_TRUE(contains(run.messages, "a.geo:12:5: error: expected")) << run.messages;
}

}  // namespace keyblock::convert_command_test
