// Linear statics says where a body rotates by more than it can know of, and what knows it gives the elastica.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::rotation_doubt_test {
namespace {

struct Done {
  int exit_code = 0;
  std::string messages;
  nlohmann::json record;
  double tip = 0;  ///< displacement along y of the measured point

  bool doubts_rotation() const { return messages.find("[rotated_beyond_linear]") != std::string::npos; }
};

Done run_of(const std::string& name, const std::string& text, const std::vector<std::string>& more = {}) {
  const std::string folder = support::fresh_folder("rotation_doubt_" + name);
  support::write_text(folder + "/in.json", text);
  std::vector<std::string> arguments = {"run", folder + "/in.json", "-o", folder + "/out"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const support::ProgramRun run = support::run_keyblock(arguments);
  return {run.exit_code, run.messages, nlohmann::json::parse(support::read_text(folder + "/out/run.json"))};
}

/// A beam of 4 by 0.2, E 1e7, I 0.2³/12, clamped at its left end, under P at the other; E I = 6666.7.
std::string cantilever(double load, const char* mesh = R"("side": 0.2, "angle": 10)") {
  return fmt::format(R"({{"keyblock": 1, "blocks": {{"blocks": [{{"outer": [[0, 0, 1], [4, 0, 1], [4, 0.2, 1],
    [0, 0.2, 1]]}}], "measured_points": [[4, 0.1, 1]]}},
    "covers": {{"functions": "quadratic", "mesh": {{{}}}, "displacements": [{{"along": [[0, 0.2], [0, 0]]}}],
    "tractions": [{{"along": [[4, 0], [4, 0.2]], "y": {}}}]}},
    "analysis": {{"velocity_carry_over": 0, "step_count": 4, "time_step": 1, "allowed_displacement_ratio": 1,
    "plane_strain": false, "gravity": 0, "joint_materials": [{{}}],
    "block_materials": [{{"density": 1, "unit_weight": 0, "youngs_modulus": 1e7, "poissons_ratio": 0}}]}}}})",
                     mesh, -load / 0.2);
}

/// A plate that a pin and a soft spring hold, moved out of line by a force: it rotates as a whole.
std::string pinned(double force) {
  return fmt::format(R"({{"keyblock": 1, "blocks": {{"blocks": [{{"outer": [[0, 0, 1], [2, 0, 1], [2, 1, 1],
    [0, 1, 1]]}}]}}, "covers": {{"contact": "ignored", "mesh": {{"side": 0.5}},
    "springs": [[0, 0, 1, 0, 1e9], [0, 0, 0, 1, 1e9], [2, 0, 0, 1, 1000]], "forces": [[2, 1, 0, {}]]}},
    "analysis": {{"velocity_carry_over": 0, "step_count": 1, "time_step": 1, "allowed_displacement_ratio": 1,
    "gravity": 0, "joint_materials": [{{}}],
    "block_materials": [{{"density": 1, "unit_weight": 0, "youngs_modulus": 1e9, "poissons_ratio": 0.2}}]}}}})",
                     force);
}

}  // namespace

TEST(RotationDoubt, a_beam_that_bends_far_under_linear_statics_is_in_doubt) {
  const Done bent = run_of("bent", cantilever(1666.67));
  EXPECT_EQ(bent.exit_code, 1) << bent.messages;
  EXPECT_TRUE(bent.doubts_rotation()) << bent.messages;
  EXPECT_NE(bent.messages.find("--set motion=relaxation"), std::string::npos) << bent.messages;
  // P L²/(2 E I) at the end: 0.0996 and 0.1032.
  EXPECT_EQ(run_of("little", cantilever(83)).exit_code, 0);
  EXPECT_EQ(run_of("more", cantilever(86)).exit_code, 1);
}

TEST(RotationDoubt, a_rigid_rotation_counts_as_much) {
  const Done turned = run_of("turned", pinned(400));  // 0.2 rad
  EXPECT_EQ(turned.exit_code, 1) << turned.messages;
  EXPECT_TRUE(turned.doubts_rotation()) << turned.messages;
  EXPECT_EQ(run_of("little_turned", pinned(180)).exit_code, 0);
}

}  // namespace keyblock::rotation_doubt_test
