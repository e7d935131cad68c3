// `keyblock check` reports every file, goes on after a bad one, and says by its exit code whether all were sound.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

namespace keyblock {
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
  const Outcome mixed = run("check " + input("04_nan_coord_orig.geo") + " " + input("00_control_xml.ana"));
  EXPECT_EQ(mixed.exit_code, 3);
  EXPECT_TRUE(contains(mixed.output,
                       "04_nan_coord_orig.geo:15:1: error: expected x of the start of line 7 of 7, found \"nan\""));
  EXPECT_TRUE(contains(mixed.output, "1000 steps"));
}

TEST(CheckCommand, files_of_several_cases_are_looked_at_alone_and_that_is_said) {
  const Outcome two = run("check " + input("00_control_orig.geo") + " " + input("00_control_orig.geo"));
  EXPECT_EQ(two.exit_code, 0);
  EXPECT_TRUE(contains(two.output, "warning: a second geometry of 2, after")) << two.output;
  EXPECT_TRUE(contains(two.output, "[several_cases]"));
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

}  // namespace keyblock
