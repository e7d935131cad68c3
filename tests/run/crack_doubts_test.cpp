// Warnings about misleading cracks: faces that overlap, faces that are bonded, paths of long increments, bodies that
// part under a constant load.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::crack_doubts_test {
namespace {

using support::ProgramRun;
using support::run_keyblock;

std::string file_of(const std::string& name, const std::string& text) {
  const std::string file = support::fresh_folder("crack_doubts_" + name) + "/in.json";
  support::write_text(file, text);
  return file;
}

ProgramRun run_of(const std::string& file) {
  return run_keyblock({"run", file, "-o", file + ".out", "--force"});
}

bool says(const ProgramRun& run, const std::string& words) {
  return run.messages.find(words) != std::string::npos;
}

std::string analysis(const std::string& joint, int steps) {
  return fmt::format(
      R"("analysis": {{"step_count": {}, "time_step": 1, "velocity_carry_over": 0, "gravity": 0, "plane_strain": true,
        "allowed_displacement_ratio": 0.1, "joint_materials": [{{{}}}], "block_materials": [{{"density": 1,
          "unit_weight": 0, "youngs_modulus": 1e5, "poissons_ratio": 0.3, "toughness": {{"mode_1": 1}}}}]}})",
      steps, joint);
}

/// A plate of 8 by 8 with a flaw of 2 at 45 degrees, under `pull` from above and below.
std::string flaw(const char* contact, double pull, const char* growth, int steps) {
  return fmt::format(
      R"({{"keyblock": 1, "blocks": {{"blocks": [{{"outer": [[-4, -4, 1], [4, -4, 1], [4, 4, 1], [-4, 4, 1]]}}]}},
      "covers": {{"contact": "{}", "mesh": {{"side": 1, "angle": 10, "tip_side": 0.025}},
        "cracks": [{{"along": [[-0.7, -0.7], [0.7, 0.7]]}}], {}
        "tractions": [{{"along": [[-4, 4], [4, 4]], "y": {}}}, {{"along": [[-4, -4], [4, -4]], "y": {}}}],
        "springs": [[4, -4, 1, 0, 1e5], [4, -4, 0, 1, 1e5], [4, 4, 1, 0, 1e5]]}}, {}}})",
      contact, growth, pull, -pull, analysis("", steps));
}

TEST(CrackDoubts, faces_that_overlap_under_pressure_are_told_by_sif_and_run) {
  const std::string pressed = file_of("pressed", flaw("ignored", -1, "", 1));
  const ProgramRun factors = run_keyblock({"sif", pressed});
  EXPECT_EQ(factors.exit_code, 1) << factors.messages;
  EXPECT_TRUE(says(factors, "below 0")) << factors.messages;
  EXPECT_TRUE(says(factors, "contact=felt")) << factors.messages;
  const ProgramRun run = run_of(pressed);
  EXPECT_EQ(run.exit_code, 1) << run.messages;
  EXPECT_TRUE(says(run, "[faces_overlap_at_tip]")) << run.messages;
  for (const std::string& open : {flaw("ignored", 1, "", 1), flaw("felt", -1, "", 1)}) {
    const ProgramRun trusted = run_of(file_of("open", open));
    EXPECT_FALSE(says(trusted, "faces_overlap_at_tip")) << trusted.messages;
  }
}

/// A plate of 2 by 4 whose drawing has a joint that ends inside, under `pull` from above.
std::string drawn_crack(double pull) {
  return fmt::format(
      R"({{"keyblock": 1, "drawing": {{"boundary_count": 4, "joints": [[0, 0, 2, 0, 1], [2, 0, 2, 4, 1],
        [2, 4, 0, 4, 1], [0, 4, 0, 0, 1], [0, 2, 0.6, 2, 1]]}}, "covers": {{"functions": "derived",
        "contact": "ignored", "mesh": {{"side": 0.25, "tip_side": 0.02}},
        "displacements": [{{"along": [[0, 0], [2, 0]]}}],
        "tractions": [{{"along": [[2, 4], [0, 4]], "y": {}}}]}}, {}}})",
      pull, analysis("", 1));
}

TEST(CrackDoubts, joints_of_a_drawing_that_end_inside_are_cracks_too) {
  for (const double pull : {-1.0, -1e3}) {
    const std::string pressed = file_of("drawn", drawn_crack(pull));
    EXPECT_EQ(run_keyblock({"sif", pressed}).exit_code, 1);
    const ProgramRun run = run_of(pressed);
    EXPECT_EQ(run.exit_code, 1) << run.messages;
    EXPECT_TRUE(says(run, "[faces_overlap_at_tip]")) << run.messages;
  }
  const ProgramRun open = run_of(file_of("drawn_open", drawn_crack(1)));
  EXPECT_EQ(open.exit_code, 0) << open.messages;
}

TEST(CrackDoubts, growth_of_a_tip_whose_faces_overlap_is_not_trusted) {
  const ProgramRun run = run_of(file_of("grows", flaw("ignored", -1, R"("growth": {"increment": 0.3},)", 1)));
  EXPECT_EQ(run.exit_code, 1) << run.messages;
  EXPECT_TRUE(says(run, "which extended in step 1")) << run.messages;
}

// A crack across the load that presses it has no K_II except noise.
TEST(CrackDoubts, a_crack_pressed_across_does_not_grow) {
  const ProgramRun run = run_of(file_of(
      "across", R"({"keyblock": 1, "blocks": {"blocks": [{"outer": [[0, -1, 1], [1, -1, 1], [1, 1, 1], [0, 1, 1]]}]},
      "covers": {"contact": "ignored", "mesh": {"side": 0.2, "angle": 10, "tip_side": 0.02},
        "cracks": [{"along": [[0, 0], [0.5, 0]]}], "growth": {"increment": 0.05},
        "tractions": [{"along": [[0, 1], [1, 1]], "y": -1}, {"along": [[0, -1], [1, -1]], "y": 1}],
        "springs": [[1, -1, 1, 0, 1e5], [1, -1, 0, 1, 1e5], [1, 1, 1, 0, 1e5]]}, )" +
                    analysis("", 3) + "}"));
  EXPECT_EQ(run.exit_code, 4) << run.messages;
  EXPECT_TRUE(says(run, "no tip extends")) << run.messages;
  EXPECT_TRUE(says(run, "pressed together")) << run.messages;
}

/// An edge crack of a half in a plate of 1 by 2 that is pulled.
std::string edge_crack(const char* contact, const std::string& joint) {
  return fmt::format(
      R"({{"keyblock": 1, "blocks": {{"blocks": [{{"outer": [[0, -1, 1], [1, -1, 1], [1, 1, 1], [0, 1, 1]]}}]}},
      "covers": {{"contact": "{}", "mesh": {{"side": 0.2, "angle": 10, "tip_side": 0.0125}},
        "cracks": [{{"along": [[0, 0], [0.5, 0]]}}],
        "tractions": [{{"along": [[0, 1], [1, 1]], "y": 1}}, {{"along": [[0, -1], [1, -1]], "y": -1}}],
        "springs": [[1, -1, 1, 0, 1e5], [1, -1, 0, 1, 1e5], [1, 1, 1, 0, 1e5]]}}, {}}})",
      contact, analysis(joint, 1));
}

TEST(CrackDoubts, bonded_faces_of_a_crack_are_told_by_sif_run_and_check) {
  const std::string bonded = R"("friction_angle_deg": 30, "cohesion": 1000, "tensile_strength": 1000)";
  const std::string file = file_of("bonded", edge_crack("felt", bonded));
  for (const ProgramRun& run : {run_keyblock({"sif", file}), run_of(file), run_keyblock({"check", file})})
    EXPECT_TRUE(says(run, "[bonded_crack_faces]") || run.output.find("[bonded_crack_faces]") != std::string::npos)
        << run.messages << run.output;
  for (const std::string& loose : {edge_crack("ignored", bonded), edge_crack("felt", R"("friction_angle_deg": 30)")}) {
    const ProgramRun run = run_of(file_of("loose", loose));
    EXPECT_FALSE(says(run, "bonded_crack_faces")) << run.messages;
  }
}

/// The tilted crack of benchmark fra-06, on a coarser mesh.
std::string tilted(double increment, int steps) {
  return fmt::format(
      R"({{"keyblock": 1, "blocks": {{"blocks": [{{"outer": [[0, -2, 1], [12, -2, 1], [12, 2, 1], [0, 2, 1]]}}]}},
      "covers": {{"contact": "ignored", "mesh": {{"side": 0.8, "angle": 10}},
        "cracks": [{{"along": [[0, 0], [3.6, 0], [3.9, 0.1]]}}], "growth": {{"increment": {}}},
        "tractions": [{{"along": [[0, 2], [0, 0]], "y": 1}}, {{"along": [[0, 0], [0, -2]], "y": -1}}],
        "springs": [[12, -2, 1, 0, 1e5], [12, -2, 0, 1, 1e5], [12, 2, 1, 0, 1e5]]}}, {}}})",
      increment, analysis("", steps));
}

TEST(CrackDoubts, increments_too_long_for_a_path_are_told) {
  const ProgramRun lengthy = run_of(file_of("lengthy", tilted(0.9, 3)));
  EXPECT_EQ(lengthy.exit_code, 0) << lengthy.messages;
  EXPECT_TRUE(says(lengthy, "[increments_too_long]")) << lengthy.messages;
  const ProgramRun brief = run_of(file_of("brief", tilted(0.1, 4)));
  EXPECT_FALSE(says(brief, "increments_too_long")) << brief.messages;
}

// A load of 5 on the top stays as the crack runs through: the upper part has no equilibrium.
TEST(CrackDoubts, a_body_that_parts_under_a_load_that_stays_is_told_at_once) {
  for (const char* turned : {R"("outer": [[0, -1, 1], [1, -1, 1], [1, 1, 1], [0, 1, 1]])"}) {
    const ProgramRun run = run_of(file_of("parts", fmt::format(R"({{"keyblock": 1, "blocks": {{"blocks": [{{{}}}]}},
      "covers": {{"contact": "felt", "mesh": {{"side": 0.25, "angle": 10, "tip_side": 0.01}},
        "cracks": [{{"along": [[0, 0], [0.7, 0]]}}], "growth": {{"increment": 0.15, "loads": "given"}},
        "tractions": [{{"along": [[0, 1], [1, 1]], "y": 5}}],
        "displacements": [{{"along": [[0, -1], [1, -1]]}}]}}, {}}})",
                                                               turned, analysis("", 6))));
    EXPECT_EQ(run.exit_code, 4) << run.messages;
    EXPECT_TRUE(says(run, "cracks part a body")) << run.messages;
  }
}

}  // namespace
}  // namespace keyblock::crack_doubts_test
