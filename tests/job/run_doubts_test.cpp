// Runs whose results cannot be trusted end with 1 and say why; their like that can be trusted end with 0.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/run_doubts.hpp"

#include <gtest/gtest.h>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::run_doubts_test {
namespace {

using support::fresh_folder;
using support::run_keyblock;
using support::write_text;

/// A held floor and a block of 1 m with its lower side at the height `low`.
std::string block_over_floor(const std::string& low, const std::string& high, const std::string& modulus) {
  return R"({"keyblock": 1, "blocks": {"blocks": [
    {"material": 1, "outer": [[-2, -1, 1], [3, -1, 1], [3, 0, 1], [-2, 0, 1]]},
    {"material": 2, "outer": [[0, )" +
         low + ", 1], [1, " + low + ", 1], [1, " + high + ", 1], [0, " + high + R"(, 1]]}],
    "fixed_points": [[-1.9, -0.9, 1], [2.9, -0.1, 1]]},
    "analysis": {"velocity_carry_over": 1, "step_count": 5, "time_step": 0.001, "allowed_displacement_ratio": 0.05,
    "block_materials": [
      {"density": 2500, "unit_weight": 24525, "youngs_modulus": 5e9, "poissons_ratio": 0},
      {"density": 2500, "unit_weight": 24525, "youngs_modulus": )" +
         modulus + R"(, "poissons_ratio": 0}],
    "joint_materials": [{"friction_angle_deg": 30, "cohesion": 0, "tensile_strength": 0}],
    "penalty_factor": 10, "gravity": 9.81}})";
}

support::ProgramRun run_of(const std::string& folder, const std::string& text, const std::string& profile) {
  const std::string out = fresh_folder(folder);
  write_text(out + "/in.json", text);
  return run_keyblock({"run", out + "/in.json", "--profile", profile, "-o", out + "/out"});
}

void expect_trusted(const support::ProgramRun& run) {
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_EQ(run.messages.find("not to be trusted"), std::string::npos) << run.messages;
}

void expect_doubted(const support::ProgramRun& run, const std::string& why) {
  EXPECT_EQ(run.exit_code, 1) << run.messages;
  EXPECT_NE(run.messages.find("the results are not to be trusted: " + why), std::string::npos) << run.messages;
}

}  // namespace

TEST(RunDoubts, a_block_at_rest_on_a_floor_is_trusted) {
  for (const char* profile : {"standard", "legacy"})
    expect_trusted(run_of("doubt_none", block_over_floor("0", "1", "5e9"), profile));
}

// Half of it in the floor from the start: springs of legacy do not push it out in five steps.
TEST(RunDoubts, blocks_that_overlap_at_the_end_are_doubted_whatever_the_contacts_saw) {
  expect_doubted(run_of("doubt_overlap", block_over_floor("-0.5", "0.5", "5e9"), "legacy"),
                 "block 1 and block 2 have 0.5 of the smaller one's area in common at the end");
}

// Its weight presses a block of E = 2e4 by γ h / 2E = 0.6 of its height in the mean, before the first step.
TEST(RunDoubts, what_the_start_crushes_counts) {
  expect_doubted(run_of("doubt_soft", block_over_floor("0", "1", "2e4"), "standard"), "block 2 was pressed to 0.3");
}

// Its weight comes at once on a block of E = 5e4, whose mean strain then swings between 0 and twice γ h / 2E = 0.25: it
// is near its unloaded area again when the run ends.
TEST(RunDoubts, what_was_crushed_between_start_and_end_counts) {
  std::string text = block_over_floor("0", "1", "5e4");
  const std::string steps = R"("step_count": 5)";
  text.replace(text.find(steps), steps.size(), R"("step_count": 900)");
  const std::string folder = fresh_folder("doubt_swings");
  write_text(folder + "/in.json", text);
  const support::ProgramRun run = run_keyblock(
      {"run", folder + "/in.json", "--set", "start=sudden", "--set", "strain_damping=none", "-o", folder + "/out"});
  expect_doubted(run, "block 2 was pressed to 0.5");
}

// Two blocks in one place on the floor: the start puts one on top of the other.
TEST(RunDoubts, a_start_that_lifts_a_block_out_of_another_is_doubted) {
  std::string text = block_over_floor("0", "1", "5e9");
  const std::string twin = R"({"material": 2, "outer": [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]})";
  text.insert(text.find(twin), twin + ", ");
  expect_doubted(run_of("doubt_lifted", text, "standard"), "the start moves block");
}

}  // namespace keyblock::run_doubts_test
