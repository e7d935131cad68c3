// Runs of rock with closing cracks: a DDA block and an NMM body that oscillate without loss, and refusals.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::cracked_rock_test {
namespace {

using support::fresh_folder;
using support::read_text;
using support::run_keyblock;
using support::write_text;

/// A unit square under an initial stress without equilibrium, in time. `more`: of the case; `closure`: of its rock.
std::string square(const std::string& more, const std::string& closure) {
  return R"({"keyblock": 1, "blocks": {"blocks": [{"outer": [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]}]})" + more +
         R"(, "analysis": {"step_count": 50, "time_step": 0.001, "allowed_displacement_ratio": 1, "plane_strain": true,
    "velocity_carry_over": 1, "joint_materials": [{}], "block_materials": [{"density": 1, "unit_weight": 0,
    "youngs_modulus": 30000, "poissons_ratio": 0.25, "initial_stress": [-30, -45, 3], "crack_closure": )" +
         closure + R"(}]}, "run": {"set": {"start": "sudden", "strain_damping": "none"}}})";
}

const std::string kClosure = R"({"initial_modulus": 10000, "closure_strain": 5e-4})";

struct Done {
  int exit_code = 0;
  std::string messages;
  nlohmann::json ledger;
  std::string out;
};

Done run_of(const std::string& name, const std::string& text, const std::vector<std::string>& more = {}) {
  const std::string folder = fresh_folder("cracked_" + name);
  write_text(folder + "/in.json", text);
  std::vector<std::string> arguments = {"run", folder + "/in.json", "-o", folder + "/out"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto run = run_keyblock(arguments);
  Done done{run.exit_code, run.messages, {}, folder + "/out"};
  if (run.exit_code != 3) done.ledger = nlohmann::json::parse(read_text(folder + "/out/run.json"))["ledger"];
  return done;
}

}  // namespace

// The initial energy oscillates between motion and strain while cracks open and close: none is lost or created.
TEST(CrackedRock, what_swings_keeps_its_energy) {
  for (const auto& [name, covers] :
       {std::pair{"block", ""}, {"covers", R"(, "covers": {"mesh": {"side": 0.5, "angle": 10}})"}}) {
    const Done done = run_of(name, square(covers, kClosure));
    ASSERT_EQ(done.exit_code, 0) << name << done.messages;
    const double largest = done.ledger["largest_energy"].get<double>();
    EXPECT_GT(largest, 1e-3);
    EXPECT_LT(std::abs(done.ledger["end"]["algorithmic"].get<double>()), 1e-9 * largest) << name;
    EXPECT_LT(done.ledger["closure"]["energy"].get<double>(), 1e-8) << name;
    EXPECT_EQ(done.ledger["end"]["plastic"].get<double>(), 0);
  }
}

// Rock without a strength cannot yield, neither DDA nor NMM: no message mentions it.
TEST(CrackedRock, rock_that_cannot_yield_has_no_plastic_outputs) {
  for (const auto& [name, covers] :
       {std::pair{"told_block", ""}, {"told_covers", R"(, "covers": {"mesh": {"side": 0.5, "angle": 10}})"}}) {
    const Done done = run_of(name, square(covers, kClosure));
    ASSERT_EQ(done.exit_code, 0) << done.messages;
    for (const char* file : {"history.csv", "blocks.csv"}) {
      const std::string text = read_text(done.out + "/" + file);
      EXPECT_EQ(text.find("plastic"), std::string::npos) << name << file;
      EXPECT_EQ(text.find("yield"), std::string::npos) << name << file;
    }
  }
}

// A column of 8 m under its weight, one DDA block on a smooth base. Dynamics begins where statics ends and stays there.
TEST(CrackedRock, a_block_whose_stress_is_no_line_of_strain_starts_in_its_equilibrium) {
  const auto column = [](const std::string& law, const char* motion) {
    return R"({"keyblock": 2, "blocks": {"blocks": [{"material": 1, "outer": [[-1, -1, 1], [3, -1, 1], [3, 0, 1],
      [-1, 0, 1]]}, {"material": 2, "outer": [[0, 0, 1], [2, 0, 1], [2, 8, 1], [0, 8, 1]]}],
      "fixed_points": [[-0.5, -0.5, 1], [2.5, -0.5, 1]]}, "analysis": {"step_count": 20, "time_step": 0.002,
      "gravity": 10, "plane_strain": true, "joint_materials": [{"friction_angle_deg": 0}], "block_materials": [
      {"density": 2500, "youngs_modulus": 1e9, "poissons_ratio": 0},
      {"density": 2500, "youngs_modulus": 1e9, "poissons_ratio": 0, )" +
           law + R"(}]}, "run": {"set": {"motion": ")" + motion + R"("}}})";
  };
  const std::string yields =
      R"("strength": {"surface": "tresca", "cohesion": 40e3, "after": {"cohesion": 80e3, "plastic_strain": 0.01}})";
  const std::string closes = R"("crack_closure": {"initial_modulus": 2e7, "closure_strain": 1e-3})";
  for (const std::string& law : {yields, closes}) {
    const Done rest = run_of("rest", column(law, "static"));
    const Done moves = run_of("moves", column(law, "dynamic"));
    EXPECT_EQ(moves.exit_code, 0) << moves.messages;
    const auto motion = [](const Done& done) {
      return nlohmann::json::parse(read_text(done.out + "/run.json"))["outcome"]["motion"];
    };
    const double way = motion(rest)["farthest"]["displacement"];
    EXPECT_NEAR(motion(moves)["farthest"]["displacement"].get<double>(), way, 1e-4 * way) << law;
    EXPECT_LT(motion(moves)["fastest"]["speed"].get<double>(), 1e-6) << law;
  }
}

TEST(CrackedRock, what_cannot_be_run_is_refused) {
  const Done legacy = run_of("legacy", square("", kClosure), {"--profile", "legacy"});
  EXPECT_EQ(legacy.exit_code, 3);
  EXPECT_NE(legacy.messages.find("expected profile standard for a crack_closure"), std::string::npos)
      << legacy.messages;
  const Done rigid = run_of("rigid", square("", kClosure), {"--set", "basis=rigid"});
  EXPECT_EQ(rigid.exit_code, 3);
  EXPECT_NE(rigid.messages.find("whose material has a crack_closure, found rigid"), std::string::npos)
      << rigid.messages;
  const Done stiff = run_of("stiff", square("", R"({"initial_modulus": 40000, "closure_strain": 5e-4})"));
  EXPECT_EQ(stiff.exit_code, 3);
  EXPECT_NE(stiff.messages.find("expected initial_modulus of crack_closure: above 0 and below youngs_modulus 30000"),
            std::string::npos)
      << stiff.messages;
}

}  // namespace keyblock::cracked_rock_test
