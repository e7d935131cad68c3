// Start of cracks in intact rock: place, load, and the warning if the mesh is too coarse.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "formats/case.hpp"
#include "formats/registry.hpp"
#include "model/continuum.hpp"
#include "run/prepare.hpp"
#include "run/steppers.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::crack_starts_test {
namespace {

struct Start {
  double load = 0;
  CrackPlan crack;
};

/// The load factor at which the first crack starts, and the crack.
Start first_start(const std::string& name, const std::string& text) {
  const std::string file = support::fresh_folder("crack_starts_" + name) + "/in.json";
  support::write_text(file, text);
  const std::unique_ptr<Stepper> stepper =
      stepper_for(prepare(formats::load_case({file}).problem, "standard", {}).scene);
  Start start;
  const auto first = stepper->advance();
  if (const auto* failure = std::get_if<StepFailure>(&first)) ADD_FAILURE() << failure->reason;
  start.load = stepper->load_factor();
  if (std::holds_alternative<StepFailure>(stepper->advance())) return start;
  if (!stepper->model().continuum->cracks.empty()) start.crack = stepper->model().continuum->cracks.front();
  return start;
}

Point middle_of(const CrackPlan& crack) {
  return crack.along.empty() ? Point{} : 0.5 * (crack.along.front() + crack.along.back());
}

std::string analysis(double toughness, double strength) {
  return fmt::format(
      R"("analysis": {{"step_count": 2, "time_step": 1, "velocity_carry_over": 0, "gravity": 0, "plane_strain": true,
        "allowed_displacement_ratio": 0.1, "joint_materials": [{{}}], "block_materials": [{{"density": 1,
          "unit_weight": 0, "youngs_modulus": 1e5, "poissons_ratio": 0.2,
          "toughness": {{"mode_1": {}, "tensile_strength": {}}}}}]}})",
      toughness, strength);
}

std::string bar(double side, double length) {
  return fmt::format(
      R"({{"keyblock": 1, "blocks": {{"blocks": [{{"outer": [[0, 0, 1], [{0}, 0, 1], [{0}, 1, 1], [0, 1, 1]]}}]}},
      "covers": {{"contact": "ignored", "mesh": {{"side": {1}, "angle": 7}}, "growth": {{"increment": 0.1}},
        "tractions": [{{"along": [[{0}, 0], [{0}, 1]], "x": 1}}, {{"along": [[0, 1], [0, 0]], "x": -1}}],
        "springs": [[0, 0, 1, 0, 1e5], [0, 0, 0, 1, 1e5], [{0}, 0, 0, 1, 1e5]]}}, {2}}})",
      length, side, analysis(1.5, 3));
}

// Uniform stress: a bar breaks at its strength on any mesh. L = (1.5/3)²/π = 0.08.
TEST(CrackStarts, a_bar_in_tension_breaks_at_its_strength_on_any_mesh) {
  for (const double side : {0.05, 0.1, 0.25})
    EXPECT_NEAR(first_start(fmt::format("bar_{}", side), bar(side, 2)).load, 3, 0.01) << side;
}

/// A plate of 20 by 20 with a hole of radius 1, pulled by 1 up and down. `near`: sides at the hole, far from it 2.
std::string plate_with_hole(double near, double toughness) {
  std::string hole, refined;
  for (int i = 0; i < 72; ++i) {
    const double angle = -i * 5 * std::numbers::pi / 180;
    const char* before = i == 0 ? "" : ", ";
    hole += fmt::format("{}[{}, {}, 1]", before, std::cos(angle), std::sin(angle));
    if (i % 3 == 0) refined += fmt::format("{}[{}, {}, {}]", before, std::cos(angle), std::sin(angle), near);
  }
  return fmt::format(
      R"({{"keyblock": 1, "blocks": {{"blocks": [{{"outer": [[-10, -10, 1], [10, -10, 1], [10, 10, 1], [-10, 10, 1]],
        "holes": [[{}]]}}]}},
      "covers": {{"contact": "ignored", "mesh": {{"side": 2, "angle": 10, "refined": [{}]}},
        "growth": {{"increment": 0.2}},
        "tractions": [{{"along": [[10, 10], [-10, 10]], "y": 1}}, {{"along": [[-10, -10], [10, -10]], "y": -1}}],
        "springs": [[10, -10, 1, 0, 1e5], [10, -10, 0, 1, 1e5], [-10, -10, 0, 1, 1e5]]}}, {}}})",
      hole, refined, analysis(toughness, 1));
}

// Kirsch: 3 at the hole; over a disc of L = 0.1 there about 2.7. Far from the hole the sides are 2, twenty times L.
TEST(CrackStarts, the_first_crack_starts_at_a_hole_however_coarse_the_mesh_is_far_from_it) {
  const double toughness = std::sqrt(0.1 * std::numbers::pi);
  for (const double near : {0.05, 0.1, 0.2}) {
    const Start start = first_start(fmt::format("hole_{}", near), plate_with_hole(near, toughness));
    const Point at = middle_of(start.crack);
    EXPECT_LT(length(at), 1.3) << near;
    EXPECT_GT(std::abs(at.x), 0.9) << near << ": where the load passes";
    EXPECT_NEAR(start.load, 0.37, 0.04) << near;
  }
}

/// An L, held above, whose arm is pulled down: its corner at (1, 1) opens. `near`: sides there.
std::string bent_l(double side, double near) {
  return fmt::format(
      R"({{"keyblock": 1, "blocks": {{"blocks": [{{"outer": [[0, 0, 1], [2, 0, 1], [2, 1, 1], [1, 1, 1], [1, 2, 1],
        [0, 2, 1]]}}]}},
      "covers": {{"contact": "ignored", "mesh": {{"side": {}, "angle": 10, "refined": [[1, 1, {}]]}},
        "growth": {{"increment": 0.2}},
        "tractions": [{{"along": [[2, 0], [2, 1]], "y": -0.1}}],
        "displacements": [{{"along": [[0, 2], [1, 2]]}}]}}, {}}})",
      side, near, analysis(std::sqrt(0.02 * std::numbers::pi), 1));
}

// L = 0.02: the load on coarse meshes is that of a mesh that resolves the stress over L.
TEST(CrackStarts, a_corner_breaks_under_the_same_load_on_coarse_meshes_as_on_a_fine_one) {
  const double fine = first_start("l_fine", bent_l(0.2, 0.008)).load;
  for (const double near : {0.02, 0.05, 0.1}) {
    const Start start = first_start(fmt::format("l_{}", near), bent_l(0.2, near));
    EXPECT_NEAR(start.load, fine, 0.15 * fine) << near;
    EXPECT_LT(distance(middle_of(start.crack), {1, 1}), near) << near;
  }
}

TEST(CrackStarts, on_a_mesh_too_coarse_for_the_rock_are_told_and_not_trusted) {
  for (const double side : {0.03, 0.1}) {
    const std::string file = support::fresh_folder("crack_starts_told") + "/in.json";
    std::string text = bar(side, 1);
    const std::string steps = R"("step_count": 2)";
    text.replace(text.find(steps), steps.size(), R"("step_count": 1)");
    support::write_text(file, text);
    const support::ProgramRun run = support::run_keyblock({"run", file, "-o", file + ".out"});
    const bool is_told = run.messages.find("[crack_start_on_coarse_mesh]") != std::string::npos;
    EXPECT_EQ(is_told, side > 0.04) << run.messages;
    EXPECT_EQ(run.exit_code, side > 0.04 ? 1 : 0) << run.messages;
  }
}

}  // namespace
}  // namespace keyblock::crack_starts_test
