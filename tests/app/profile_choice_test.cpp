// The default profile of a run, both profiles side by side, and the messages of statics without an equilibrium.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "formats/registry.hpp"
#include "formats/text/csv.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::profile_choice_test {
namespace {

using support::fresh_folder;
using support::ProgramRun;
using support::read_text;
using support::run_keyblock;

// Seven blocks of an old file that requests statics; its slices slide.
const std::string kCircle = KEYBLOCK_SOURCE_DIR "/legacy_cases/circle_slope/";
const std::string kOwn = KEYBLOCK_SOURCE_DIR "/legacy_cases/sliding_block_on_covers/a30_p20/a30_p20.json";
const std::string kSlide = KEYBLOCK_SOURCE_DIR "/legacy_cases/sliding_block/a30_p20/a30_p20";

std::vector<std::string> circle(const std::string& command, const std::vector<std::string>& more) {
  std::vector<std::string> all{command, kCircle + "circle_slope.geo", kCircle + "circle_slope.ana"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

nlohmann::json record_in(const std::string& folder) {
  return nlohmann::json::parse(read_text(folder + "/run.json"));
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST(ProfileChoice, files_of_an_old_program_take_legacy_and_it_is_said) {
  const std::string out = fresh_folder("old_file") + "/out";
  const ProgramRun run = run_keyblock(circle("run", {"-o", out}));
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_TRUE(contains(run.messages, "steps, the first of 0.01, profile legacy\n")) << run.messages;
  EXPECT_FALSE(contains(run.messages, "because")) << run.messages;
  EXPECT_EQ(record_in(out)["profile"], "legacy");
  EXPECT_EQ(record_in(out)["profile_because"], "input in a format of Shi's or the Berkeley program");
}

TEST(ProfileChoice, own_case_files_take_standard) {
  const std::string out = fresh_folder("own_file") + "/out";
  const ProgramRun run = run_keyblock({"run", kOwn, "-o", out, "--set", "steps=2", "--verbose"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_TRUE(contains(run.messages, "profile: standard, because the case is Keyblock's own")) << run.messages;
}

TEST(ProfileChoice, a_setting_that_standard_alone_reads_chooses_it) {
  const std::string folder = fresh_folder("by_setting");
  const ProgramRun run = run_keyblock(circle("run", {"-o", folder + "/out", "--set", "motion=dynamic", "--verbose"}));
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_TRUE(contains(run.messages, "profile: standard, because it alone reads the setting motion")) << run.messages;
  const auto record = record_in(folder + "/out");
  EXPECT_EQ(record["settings"]["motion"], "dynamic");
  EXPECT_EQ(record["settings"]["velocity_carry_over"], 1) << "the file's 0 would begin each step at rest";
  const ProgramRun creeping = run_keyblock(
      circle("run", {"-o", folder + "/creep", "--set", "motion=dynamic", "--set", "velocity_carry_over=0"}));
  EXPECT_EQ(record_in(folder + "/creep")["settings"]["velocity_carry_over"], 0) << creeping.messages;
}

// A block that starts sliding at rest gains kinetic energy; one that begins each step at rest keeps almost none.
TEST(ProfileChoice, dynamic_is_dynamic_on_a_static_file) {
  const std::string folder = fresh_folder("dynamic");
  const auto kinetic = [&](const std::string& name, const std::vector<std::string>& sets) {
    std::vector<std::string> more{"-o", folder + "/" + name};
    for (const std::string& set : sets) more.insert(more.end(), {"--set", set});
    run_keyblock(circle("run", more));
    const formats::CsvTable ledger = formats::read_csv(formats::load(folder + "/" + name + "/ledger.csv"));
    std::size_t at = 0;
    while (at < ledger.header.size() && !ledger.header[at].starts_with("kinetic")) ++at;
    return std::stod(ledger.rows.back().cells.at(at));
  };
  EXPECT_GT(kinetic("moving", {"motion=dynamic"}),
            10 * kinetic("creeping", {"motion=dynamic", "velocity_carry_over=0"}));
}

TEST(ProfileChoice, no_equilibrium_names_block_place_area_and_what_to_try) {
  const std::string out = fresh_folder("no_rest") + "/out";
  const ProgramRun run = run_keyblock(circle("run", {"-o", out, "--profile", "standard"}));
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_TRUE(contains(run.messages, "no equilibrium: block 7 accelerates (at ")) << run.messages;
  EXPECT_TRUE(
      contains(run.messages, "\n  help: --set motion=dynamic shows the motion; --profile legacy starts each step"))
      << run.messages;
  EXPECT_TRUE(contains(run.messages, "; keyblock fos ")) << run.messages;
  EXPECT_TRUE(contains(run.messages, "/picture.svg (block 7 is marked)")) << run.messages;
  const auto outcome = record_in(out)["outcome"];
  EXPECT_EQ(outcome["blocks"], nlohmann::json::array({7}));
  EXPECT_EQ(outcome["try"].size(), 2U);
  EXPECT_TRUE(contains(read_text(out + "/picture.svg"), "block 7: no equilibrium"));
}

TEST(ProfileChoice, legacy_that_breaks_off_names_block_and_limit) {
  const std::string out = fresh_folder("breaks_off") + "/out";
  const ProgramRun run =
      run_keyblock({"run", kSlide + ".geo", kSlide + ".ana", "-o", out, "--set", "allowed_displacement_ratio=1e-9"});
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_TRUE(contains(run.messages, "blocks move too far even at the smallest step: block 2 at ")) << run.messages;
  EXPECT_TRUE(contains(run.messages, "3 times allowed_displacement_ratio")) << run.messages;
  EXPECT_TRUE(contains(run.messages, "drawn with 2, ")) << run.messages;
  EXPECT_TRUE(contains(run.messages, "Shi's programs repeat such a step without end")) << run.messages;
  EXPECT_FALSE(contains(run.messages, "would have ended here too")) << run.messages;
  EXPECT_TRUE(contains(run.messages, "--profile standard")) << run.messages;
  EXPECT_EQ(record_in(out)["outcome"]["blocks"], nlohmann::json::array({2}));
}

TEST(ProfileChoice, both_stand_side_by_side) {
  const std::string folder = fresh_folder("both");
  const ProgramRun run = run_keyblock(circle("run", {"-o", folder + "/out", "--both"}));
  EXPECT_EQ(run.exit_code, 1) << run.messages;
  EXPECT_TRUE(contains(run.output, "end                          finished                     failed")) << run.output;
  EXPECT_TRUE(contains(run.output, "differs  end: finished and failed")) << run.output;
  EXPECT_TRUE(contains(run.output, "because  standard failed: step 1")) << run.output;
  EXPECT_TRUE(contains(run.output, "because  the case is static")) << run.output;
  for (const char* profile : {"legacy", "standard"})
    EXPECT_EQ(record_in(folder + "/out/" + profile)["profile"], profile);
  const ProgramRun alike = run_keyblock(
      {"run", kSlide + ".geo", kSlide + ".ana", "-o", folder + "/alike", "--both", "--json", "--set", "steps=100"});
  EXPECT_EQ(alike.exit_code, 0) << alike.messages;
  const auto json = nlohmann::json::parse(alike.output);
  EXPECT_EQ(json["profiles"][0]["profile"], "legacy");
  EXPECT_EQ(json["profiles"][1]["end"], "finished");
  // Theory: g t²/2 (sin 30° − cos 30° tan 20°) after 100 steps of 1 ms.
  EXPECT_NEAR(json["profiles"][1]["greatest_displacement"]["value"].get<double>() / 0.0090637, 1, 1e-3);
  EXPECT_EQ(run_keyblock(circle("run", {"-o", folder + "/no", "--both", "--profile", "legacy"})).exit_code, 2);
}

// Stresses of 1e-12 of the modulus are round-off: a falling block has none. Runs with different end times are not
// compared.
TEST(ProfileChoice, round_off_is_no_difference_and_other_times_are_told) {
  const std::string folder = fresh_folder("both_noise");
  const std::string fall = KEYBLOCK_SOURCE_DIR "/legacy_cases/free_fall/released/released";
  const ProgramRun same = run_keyblock({"run", fall + ".geo", fall + ".ana", "-o", folder + "/out", "--both"});
  EXPECT_EQ(same.exit_code, 0) << same.messages;
  EXPECT_TRUE(contains(same.output, "no difference above 1 %")) << same.output;
}

TEST(ProfileChoice, a_profile_that_cannot_be_run_is_told_beside_the_other) {
  const std::string out = fresh_folder("both_covers") + "/out";
  const ProgramRun run = run_keyblock({"run", kOwn, "-o", out, "--both", "--set", "steps=2"});
  EXPECT_EQ(run.exit_code, 1) << run.messages;
  EXPECT_TRUE(contains(run.output, "because  legacy was not run: ")) << run.output;
}

}  // namespace keyblock::profile_choice_test
