// All commands get the same files, profile, settings and mesh of a case.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "api/plan.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "api/case_folder.hpp"
#include "settings/profile.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::plan_test {
namespace {

const std::string kCases = KEYBLOCK_SOURCE_DIR "/legacy_cases/";

/// A plate on covers with a mesh of sides of 0.5 and these settings under run.set.
std::string plate(const std::string& set) {
  return R"({"keyblock": 1, "blocks": {"blocks": [{"outer": [[0, 0, 1], [2, 0, 1], [2, 1, 1], [0, 1, 1]]}]},
 "covers": {"mesh": {"side": 0.5}, "displacements": [{"along": [[0, 0], [0, 1]]}]},
 "analysis": {"step_count": 1, "time_step": 1, "allowed_displacement_ratio": 0.1,
  "block_materials": [{"density": 1, "unit_weight": 1, "youngs_modulus": 1000, "poissons_ratio": 0.3}],
  "joint_materials": [{}]},
 "run": {"set": {)" +
         set + "}}}";
}

int unknowns_of(const std::string& file, const std::vector<Override>& sets) {
  const OpenCase open = opened(asked_case({{file}, {}, {}, sets}));
  return planned(open, open.input.problem).prepared.requirements.unknowns;
}

}  // namespace

TEST(Plan, every_case_folder_can_be_configured_in_each_profile_that_it_runs) {
  int configured_cases = 0;
  for (const CaseFolder& folder : find_cases({kCases})) {
    if (!folder.has_expected) continue;
    const AskedCase asked = asked_case({{folder.folder.string()}, {}, {}, {}});
    const formats::Case input = formats::load_case(asked.files);
    const ChosenProfile chosen = profile_for(asked, input.problem);
    EXPECT_FALSE(asked.file.not_run.contains(rules_of(chosen.name))) << folder.name;
    // A static search takes the same plan if the case is in no old format, or has no legacy results.
    const std::string of_statics = profile_for(asked, input.problem, OldFiles::standard).name;
    EXPECT_EQ(of_statics, chosen.name == "legacy" ? "standard" : chosen.name) << folder.name;
    for (const std::string& profile : {chosen.name, of_statics})
      EXPECT_NO_THROW(configured_under(profile, asked, input.problem)) << folder.name;
    ++configured_cases;
  }
  EXPECT_GT(configured_cases, 290);
}

TEST(Plan, a_case_folder_that_does_not_run_legacy_takes_standard_and_says_why) {
  const AskedCase asked = asked_case({{kCases + "bolt/breaking"}, {}, {}, {}});
  const formats::Case input = formats::load_case(asked.files);
  const ChosenProfile chosen = profile_for(asked, input.problem);
  EXPECT_EQ(chosen.name, "standard");
  EXPECT_NE(chosen.why.find("case.json, under legacy: "), std::string::npos) << chosen.why;
  const AskedCase legacy = asked_case({{kCases + "bolt/breaking"}, {}, "legacy", {}});
  EXPECT_THROW(profile_for(legacy, input.problem), UsageError);
}

TEST(Plan, settings_of_the_command_line_come_after_those_of_the_settings_file_and_of_the_case) {
  const std::string folder = support::fresh_folder("asked_order");
  support::write_text(folder + "/a.settings", "profile = draft\nsteps = 7\nbody_acceleration_file = shake.csv\n");
  const AskedCase asked = asked_case({{kCases + "newmark_sine/row_1"}, folder + "/a.settings", {}, {{"steps", "9"}}});
  EXPECT_EQ(asked.profile, "draft");
  const std::vector<Override> all = asked.overrides("draft");
  const std::vector<Override> last(all.end() - 3, all.end());
  EXPECT_EQ(last,
            (std::vector<Override>{{"steps", "7"}, {"body_acceleration_file", folder + "/shake.csv"}, {"steps", "9"}}));
  EXPECT_EQ(all.front(), (Override{"body_acceleration_file", kCases + "newmark_sine/row_1/motion.csv"}));
}

TEST(Plan, a_setting_of_case_json_that_does_not_fit_is_told_with_its_file) {
  const std::string folder = support::fresh_folder("asked_wrong") + "/c";
  std::filesystem::copy(kCases + "sliding_block/a30_p20", folder);
  for (const char* ending : {".geo", ".ana"})
    std::filesystem::rename(folder + "/a30_p20" + ending, folder + "/c" + ending);
  support::write_text(folder + "/case.json", R"({"set": {"both": {"mesh.side": "0.5"}}})");
  const OpenCase open = opened(asked_case({{folder}, {}, {}, {}}));
  try {
    planned(open, open.input.problem);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("case.json: error: there is no setting \"mesh.side\""), std::string::npos)
        << error.what();
  }
}

TEST(Plan, a_case_file_may_set_its_mesh_and_the_command_line_overrules_it) {
  const std::string folder = support::fresh_folder("asked_mesh");
  support::write_text(folder + "/side.json", plate(R"("mesh.side": "0.125")"));
  support::write_text(folder + "/plain.json", plate(""));
  support::write_text(folder + "/wrong.json", plate(R"("mesh.side": "-1")"));
  const int plain = unknowns_of(folder + "/plain.json", {});
  EXPECT_GT(unknowns_of(folder + "/side.json", {}), 4 * plain);
  EXPECT_EQ(unknowns_of(folder + "/side.json", {}), unknowns_of(folder + "/plain.json", {{"mesh.side", "0.125"}}));
  EXPECT_EQ(unknowns_of(folder + "/side.json", {{"mesh.side", "0.5"}}), plain);
  EXPECT_THROW(unknowns_of(folder + "/wrong.json", {}), InputError);
  EXPECT_THROW(unknowns_of(folder + "/plain.json", {{"mesh.side", "-1"}}), std::invalid_argument);
}

}  // namespace keyblock::plan_test
