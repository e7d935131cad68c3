// Messages of runs of elastoplastic rock about steps that are too long, and about a missing equilibrium.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::yielding_messages_test {
namespace {

struct Done {
  int exit_code = 0;
  std::string messages;
  nlohmann::json record;

  bool says(const std::string& words) const { return messages.find(words) != std::string::npos; }
};

Done run_of(const std::string& name, const std::string& text, const std::vector<std::string>& more = {}) {
  const std::string folder = support::fresh_folder("yielding_messages_" + name);
  support::write_text(folder + "/in.json", text);
  std::vector<std::string> arguments = {"run", folder + "/in.json", "-o", folder + "/out"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const support::ProgramRun run = support::run_keyblock(arguments);
  return {run.exit_code, run.messages, nlohmann::json::parse(support::read_text(folder + "/out/run.json"))};
}

/// A block that falls by a hundredth upon an NMM body, which a pretensioned bolt presses until it yields.
const std::string kSqueezed = R"({"keyblock": 1, "blocks": {"blocks": [
  {"outer": [[-2, -1, 1], [3, -1, 1], [3, 0, 1], [-2, 0, 1]], "material": 1},
  {"outer": [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], "material": 2},
  {"outer": [[0, 1, 1], [1, 1, 1], [1, 2, 1], [0, 2, 1]], "material": 3}],
  "fixed_points": [[-2, -1, 1], [3, -1, 1], [-2, 0, 1], [3, 0, 1]],
  "bolts": [[0.5, -0.5, 0.5, 0.9, 1, 2, 1e4, 1e9, 60]]},
  "analysis": {"step_count": 200, "time_step": 0.005, "velocity_carry_over": 1, "gravity": 10, "plane_strain": true,
  "allowed_displacement_ratio": 0.05, "joint_materials": [{}], "block_materials": [
  {"density": 1, "unit_weight": 10, "youngs_modulus": 1e7, "poissons_ratio": 0.3},
  {"density": 1, "unit_weight": 10, "youngs_modulus": 1e5, "poissons_ratio": 0.3,
   "strength": {"surface": "tresca", "cohesion": 20}},
  {"density": 1, "unit_weight": 10, "youngs_modulus": 1e7, "poissons_ratio": 0.3}]},
  "covers": {"mesh": {"side": 0.3, "materials": [[2]]}}})";

/// A smooth pillar on a mesh rotated by 10°, pressed by a twentieth of its height (`press`).
std::string pillar(const std::string& press, const std::string& load) {
  return R"({"keyblock": 1, "blocks": {"blocks": [{"outer": [[0, 0, 1], [1, 0, 1], [1, 2, 1], [0, 2, 1]]}]},
    "covers": {"contact": "ignored", "mesh": {"side": 0.25, "angle": 10},
    "displacements": [{"along": [[0, 0], [1, 0]], "held": "y"})" +
         press + "], " + load + R"("springs": [[0.5, 0, 1, 0, 0.001]]},
    "analysis": {"step_count": 40, "time_step": 1, "velocity_carry_over": 0, "gravity": 0, "plane_strain": true,
    "allowed_displacement_ratio": 0.1, "joint_materials": [{}], "block_materials": [{"density": 1, "unit_weight": 0,
    "youngs_modulus": 1000, "poissons_ratio": 0.3, "strength": {"surface": "mohr_coulomb", "cohesion": 1,
    "friction_deg": 30, "dilation_deg": 30}}]}})";
}

const std::vector<std::string> kAlong{"--set steps=200", "--set load_control=arc_length"};

}  // namespace

// Plastic work is counted with the stress at the end of each step, the force with the mean. Their difference falls with
// the step, and the sum of both columns is nearer to that of short steps than plastic work alone.
TEST(YieldingMessages, steps_that_overstate_plastic_work_are_told) {
  const std::vector<std::string> sudden{"--set", "start=sudden"};  // the bolt presses at once
  const Done coarse = run_of("coarse", kSqueezed, sudden);
  ASSERT_EQ(coarse.exit_code, 0) << coarse.messages;
  EXPECT_TRUE(coarse.says("[plastic_work_overstated]")) << coarse.messages;
  const Done fine =
      run_of("fine", kSqueezed, {"--set", "start=sudden", "--set", "time_step=0.000625", "--set", "steps=1600"});
  ASSERT_EQ(fine.exit_code, 0) << fine.messages;
  EXPECT_FALSE(fine.says("plastic_work_overstated")) << fine.messages;
  const auto end = [](const Done& done, const char* column) {
    return done.record["ledger"]["end"][column].get<double>();
  };
  EXPECT_LT(end(coarse, "algorithmic"), -0.1 * end(coarse, "plastic"));
  EXPECT_LT(std::abs(end(fine, "algorithmic")), 0.02 * end(fine, "plastic"));
  const double both = end(coarse, "plastic") + end(coarse, "algorithmic");
  EXPECT_LT(std::abs(both - end(fine, "plastic")), std::abs(end(coarse, "plastic") - end(fine, "plastic")) / 4);
  EXPECT_LT(coarse.record["ledger"]["closure"]["energy"].get<double>(), 1e-6);
}

// If the solver finds the equilibrium there is no message; the words are those of a step that is cut.
TEST(YieldingMessages, advice_after_a_load_step_can_be_followed) {
  const Done loaded = run_of("loaded", pillar("", R"("tractions": [{"along": [[1, 2], [0, 2]], "pressure": 8}], )"));
  ASSERT_EQ(loaded.exit_code, 4) << loaded.messages;
  EXPECT_TRUE(loaded.says("of the loads of this scene was found")) << loaded.messages;
  EXPECT_TRUE(loaded.says("limit load of this mesh: ")) << loaded.messages;
  EXPECT_FALSE(loaded.says("legacy")) << loaded.messages;
  EXPECT_EQ(loaded.record["outcome"]["try"], nlohmann::json(kAlong));
  const Done along = run_of("along", pillar("", R"("tractions": [{"along": [[1, 2], [0, 2]], "pressure": 8}], )"),
                            {"--set", "load_control=arc_length"});
  EXPECT_NE(along.exit_code, 2) << along.messages;
  EXPECT_FALSE(along.says("expected")) << along.messages;
}

// An edge that is driven inward by more than the body is wide turns elements over with any steps.
TEST(YieldingMessages, a_driven_edge_is_not_said_to_have_a_limit_load) {
  const Done driven =
      run_of("driven", pillar(R"(, {"along": [[1, 2], [0, 2]], "held": "y", "y": -2.5})", ""), {"--set", "steps=4"});
  ASSERT_EQ(driven.exit_code, 4) << driven.messages;
  EXPECT_TRUE(driven.says("of the displacements and loads of this scene was found")) << driven.messages;
  EXPECT_FALSE(driven.says("limit load of this mesh")) << driven.messages;
  EXPECT_TRUE(driven.says("stopped: no equilibrium")) << driven.messages;
  EXPECT_TRUE(driven.says("edges are driven, so that this need not be a limit load: more steps may go on"))
      << driven.messages;
  EXPECT_EQ(driven.record["outcome"]["try"][0], "--set steps=20");
}

}  // namespace keyblock::yielding_messages_test
