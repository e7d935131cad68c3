// sif takes the case that run takes, a wrong setting is wrong usage of every command, and help is no error.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::one_plan_test {
namespace {

using Json = nlohmann::json;
using support::fresh_folder;
using support::ProgramRun;
using support::read_text;
using support::run_keyblock;

const std::string kCases = KEYBLOCK_SOURCE_DIR "/legacy_cases/";

// A plate with a crack that ends inside; its file names a table of the acceleration of the body.
constexpr const char* kCracked =
    R"({"keyblock": 1, "blocks": {"blocks": [{"outer": [[-1, -2, 1], [1, -2, 1], [1, 2, 1], [-1, 2, 1]]}]},
 "covers": {"contact": "ignored", "mesh": {"side": 0.4, "tip_side": 0.05}, "cracks": [{"along": [[-0.5, 0], [0.5, 0]]}],
  "displacements": [{"along": [[-1, -2], [1, -2]]}], "tractions": [{"along": [[-1, 2], [1, 2]], "y": 1}]},
 "analysis": {"step_count": 1, "time_step": 1, "allowed_displacement_ratio": 0.1, "plane_strain": true,
  "block_materials": [{"density": 1, "unit_weight": 0, "youngs_modulus": 100000, "poissons_ratio": 0.3}],
  "joint_materials": [{}]},
 "run": {"set": {"body_acceleration_file": "shake.csv"}}})";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST(OnePlan, sif_takes_the_case_that_run_takes) {
  const std::string folder = fresh_folder("one_plan_sif");
  support::write_text(folder + "/crack.json", kCracked);
  support::write_text(folder + "/shake.csv", "time,ax,ay\n0,0,0\n10,0,0\n");
  const ProgramRun sif = run_keyblock({"sif", folder + "/crack.json", "--json", "--set", "mesh.side=0.3"});
  EXPECT_NE(sif.exit_code, 3) << sif.messages;
  const ProgramRun check =
      run_keyblock({"check", folder + "/crack.json", "--json", "--trial", "0", "--set", "mesh.side=0.3"});
  EXPECT_EQ(check.exit_code, 0) << check.messages;
  EXPECT_EQ(Json::parse(sif.output)["profile"], Json::parse(check.output)["case"]["profile"]);
  EXPECT_EQ(Json::parse(sif.output)["unknowns"], Json::parse(check.output)["case"]["requires"]["unknowns"]);
}

TEST(OnePlan, a_wrong_setting_is_wrong_usage_of_every_command) {
  const std::string folder = fresh_folder("one_plan_usage");
  support::write_text(folder + "/crack.json", kCracked);
  support::write_text(folder + "/shake.csv", "time,ax,ay\n0,0,0\n10,0,0\n");
  const std::string crack = folder + "/crack.json";
  const std::string slide = kCases + "sliding_block/a30_p20";
  for (const char* set : {"nonsense=1", "steps=0", "nonsense"})
    for (const std::vector<std::string>& command : {std::vector<std::string>{"run", slide, "-o", folder + "/out"},
                                                    {"check", slide},
                                                    {"fos", slide},
                                                    {"sif", crack},
                                                    {"tradeoff", slide},
                                                    {"sweep", slide},
                                                    {"run", slide, "--reduce-strength", "joints"}}) {
      std::vector<std::string> arguments = command;
      arguments.insert(arguments.end(), {"--set", set});
      const ProgramRun run = run_keyblock(arguments);
      EXPECT_EQ(run.exit_code, 2) << command[0] << " " << set << ": " << run.messages;
    }
  EXPECT_EQ(run_keyblock({"sif", crack, "--set", "mesh.side=-1"}).exit_code, 2);
}

TEST(OnePlan, help_is_no_error) {
  for (const std::vector<std::string>& asked : {std::vector<std::string>{}, {"help"}, {"--help"}}) {
    const ProgramRun help = run_keyblock(asked);
    EXPECT_EQ(help.exit_code, 0) << help.messages;
    EXPECT_TRUE(contains(help.output, "compare")) << help.output;
  }
  const ProgramRun run = run_keyblock({"help", "run"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.output, run_keyblock({"run", "--help"}).output);
  EXPECT_EQ(run_keyblock({"help", "fly"}).exit_code, 2);
}

TEST(OnePlan, a_format_may_be_named_by_its_ending) {
  const std::string folder = fresh_folder("one_plan_format");
  const std::string slide = kCases + "sliding_block/a30_p20";
  const ProgramRun batch = run_keyblock({"batch", slide, "--convert", "json", "-o", folder + "/out"});
  EXPECT_EQ(batch.exit_code, 0) << batch.messages;
  const ProgramRun wrong = run_keyblock({"batch", slide, "--convert", "keyblok-case", "-o", folder + "/no"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_TRUE(contains(wrong.messages, "did you mean \"keyblock-case\"?")) << wrong.messages;
  EXPECT_EQ(run_keyblock(
                {"convert", slide + "/a30_p20.geo", slide + "/a30_p20.ana", "--to", "json", "-o", folder + "/a.case"})
                .exit_code,
            0);
}

}  // namespace keyblock::one_plan_test
