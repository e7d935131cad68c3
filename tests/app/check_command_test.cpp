// `keyblock check` reports every file, continues after a bad one, and returns an exit code that says if all were sound.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::check_command_test {
namespace {

struct Outcome {
  int exit_code = 0;
  std::string output;
};

Outcome run(const std::string& arguments) {
  Outcome result;
  FILE* pipe = popen((KEYBLOCK_PROGRAM " " + arguments).c_str(), "r");
  std::array<char, 4096> buffer;
  while (const std::size_t size = fread(buffer.data(), 1, buffer.size(), pipe))
    result.output.append(buffer.data(), size);
  result.exit_code = WEXITSTATUS(pclose(pipe));
  return result;
}

std::string input(const std::string& name) {
  return KEYBLOCK_SOURCE_DIR "/tests/malformed/" + name;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST(CheckCommand, sound_case_says_dialect_evidence_and_counts) {
  const Outcome sound = run("check " + input("00_control_orig.geo") + " " + input("00_control_xml.ana"));
  EXPECT_EQ(sound.exit_code, 0);
  EXPECT_TRUE(contains(sound.output, "[dda-geometry]: 9-number head gives 62 numbers, the file has 62"))
      << sound.output;
  EXPECT_TRUE(contains(sound.output, "7 lines, 0 boundary lines"));
  EXPECT_TRUE(contains(sound.output, "1000 steps, 1 block materials"));
}

TEST(CheckCommand, bad_file_does_not_keep_the_others_from_being_reported) {
  const Outcome mixed = run("check " + input("04_nan_coord_orig.geo") + " " + input("00_control_xml.ana") + " 2>&1");
  EXPECT_EQ(mixed.exit_code, 3);
  EXPECT_TRUE(contains(mixed.output,
                       "04_nan_coord_orig.geo:15:1: error: expected x of the start of line 7 of 7, found \"nan\""));
  EXPECT_TRUE(contains(mixed.output, "1000 steps"));
}

TEST(CheckCommand, files_of_several_cases_are_looked_at_alone_and_that_is_said) {
  const Outcome two = run("check " + input("00_control_orig.geo") + " " + input("00_control_orig.geo"));
  EXPECT_EQ(two.exit_code, 0);
  EXPECT_TRUE(contains(two.output, "note: a second geometry of 2, after")) << two.output;
  EXPECT_TRUE(contains(two.output, "[several_cases]"));
}

TEST(CheckCommand, a_drawing_alone_cannot_run_and_that_is_said) {
  const std::string drawing = KEYBLOCK_SOURCE_DIR "/docs/bench.dxf";
  const Outcome said = run("check " + drawing);
  EXPECT_EQ(said.exit_code, 0);
  EXPECT_TRUE(contains(said.output, "no analysis: a run needs a case file with steps and materials")) << said.output;
  EXPECT_EQ(nlohmann::json::parse(run("check --json " + drawing).output)["case"]["lacks"], "analysis");
  const std::string analysis = KEYBLOCK_SOURCE_DIR "/docs/bench.json";
  EXPECT_EQ(nlohmann::json::parse(run("check --json " + analysis).output)["case"]["lacks"], "geometry");
  EXPECT_FALSE(nlohmann::json::parse(run("check --json --trial 0 " + drawing + " " + analysis).output)["case"].contains(
      "lacks"));
}

TEST(CheckCommand, json_holds_the_same_report) {
  const Outcome run_json =
      run("check --json " + input("06_joint_type_out_of_range_xml.geo") + " " + input("00_control_xml.ana"));
  const auto json = nlohmann::json::parse(run_json.output);
  EXPECT_EQ(json["files"][0]["format"], "ddaml");
  EXPECT_EQ(json["files"][0]["counts"]["lines"], 7);
  EXPECT_EQ(json["case"]["warnings"][0]["name"], "joint_material_clamped");
  EXPECT_EQ(json["case"]["warnings"][0]["line"], 8);
}

// A case file with one square, the contents of its key "run", and more keys of "run".
std::string case_with(const std::string& run, const std::string& more = "") {
  const std::string file = support::fresh_folder("check_case") + "/case.json";
  support::write_text(file, R"({"keyblock": 1,
 "blocks": {"blocks": [{"material": 1, "outer": [[0, 0, 1], [1, 0, 1], [1, 1, 1]]}],
  "fixed_points": [[0.5, 0.25, 1]]},
 "analysis": {"step_count": 1, "time_step": 0.01, "allowed_displacement_ratio": 0.1,
  "block_materials": [{"density": 1, "youngs_modulus": 1e6}], "joint_materials": [{"friction_angle_deg": 30}]},
 "run": )" + run + more + "}");
  return file;
}

TEST(CheckCommand, a_profile_or_setting_of_a_case_file_that_is_none_is_named_where_it_stands) {
  const std::vector<std::pair<std::string, std::string>> faults{
      {R"({"profile": "legcy"})",
       ":6:21: error: expected a profile, one of legacy, draft, standard, reference, found \"legcy\"\n"},
      {R"({"set": {"motion": "statik"}})", ":6:18: error: setting motion: expected "},
      {R"({"set": {"motion": "static", "steps": 2.5}})",
       ":6:38: error: setting steps: expected a whole number of at least 1, found \"2.5\"\n"},
      {R"({"set": {"ledger": 7}})", ":6:18: error: setting ledger: expected one of off, on, found \"7\"\n"},
      {R"({"set": {"time_step": true}})", ":6:18: error: setting time_step: expected "},
      {R"({"set": {"motion": "static", "motoin": "static"}})", ":6:38: error: there is no setting \"motoin\""}};
  for (const auto& [choices, message] : faults) {
    const std::string file = case_with(choices);
    for (const std::string command : {"check", "run"}) {
      std::vector<std::string> arguments{command, file};
      if (command == "run") arguments.insert(arguments.end(), {"-o", support::fresh_folder("check_case_run")});
      const auto run = support::run_keyblock(arguments);
      EXPECT_EQ(run.exit_code, 3) << command << choices;
      EXPECT_TRUE(contains("\n" + run.messages, "\n" + file + message)) << run.messages;
    }
  }
}

// Histories of things that the scene lacks.
TEST(CheckCommand, outputs_that_a_run_refuses_are_refused) {
  const std::vector<std::pair<std::string, std::string>> faults{
      {R"({"histories": [{"block": 99}]})",
       ":7:27: error: expected the number of a block in a history, 1 to 1, found 99"},
      {R"({"histories": [{"point": [5, 5]}]})", ":7:27: error: expected the point of a history within a block"},
      {R"({"contacts": "chosen"})", ":7:12: error: expected a history of a block, a contact or a joint"}};
  for (const auto& [outputs, message] : faults) {
    const std::string file = case_with("{}", ",\n\"outputs\": " + outputs);
    for (const std::string command : {"check", "run"}) {
      std::vector<std::string> arguments{command, file};
      if (command == "run") arguments.insert(arguments.end(), {"-o", support::fresh_folder("check_case_run")});
      const auto run = support::run_keyblock(arguments);
      EXPECT_EQ(run.exit_code, 3) << command << outputs;
      EXPECT_TRUE(contains(run.messages, file + message)) << command << ": " << run.messages;
    }
  }
}

TEST(CheckCommand, a_case_file_that_holds_nothing_is_said_and_not_run) {
  const std::string file = support::fresh_folder("check_empty") + "/case.json";
  const std::vector<std::string> run{"run", file, "-o", support::fresh_folder("check_empty_run")};
  support::write_text(file, "{\"keyblock\": 1}");
  const auto check = support::run_keyblock({"check", file});
  EXPECT_TRUE(contains(check.output, file + ":1:1: warning: the case file holds nothing")) << check.output;
  for (const char* text : {"{\"keyblock\": 1}", "{\"keyblock\": 1, \"units\": {\"length\": \"m\"}}"}) {
    support::write_text(file, text);
    const auto refused = support::run_keyblock(run);
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_EQ(refused.messages, file + ": error: expected a geometry or an analysis, found neither\n");
  }
}

}  // namespace keyblock::check_command_test
