// Growth of cracks between two steps, and bodies that a crack cuts in two.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "formats/case.hpp"
#include "formats/registry.hpp"
#include "run/checkpoint.hpp"
#include "run/prepare.hpp"
#include "run/record.hpp"
#include "run/run.hpp"
#include "run/steppers.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::crack_growth_test {
namespace {

Problem problem_of(const std::string& file) {
  return formats::load_case({file}).problem;
}

std::string bytes_of(Stepper& stepper) {
  Archive archive;
  stepper.save(archive);
  return checkpoint_bytes(archive);
}

TEST(CrackGrowth, left_before_any_step_it_goes_on_to_the_same_bytes) {
  const std::string file =
      KEYBLOCK_SOURCE_DIR "/legacy_cases/crack_growth/cantilever_straight/cantilever_straight.json";
  Problem problem = problem_of(file);
  problem.analysis->step_count = 3;
  const Scene scene = prepare(problem, "standard", {}).scene;
  const std::unique_ptr<Stepper> whole = stepper_for(scene);
  std::vector<std::string> saved;
  for (int step = 0; step < 3; ++step) {
    saved.push_back(bytes_of(*whole));
    ASSERT_TRUE(std::holds_alternative<StepReport>(whole->advance()));
  }
  ASSERT_EQ(whole->tips().size(), 1U);
  EXPECT_NEAR(whole->tips().front().equivalent, 1000, 1e-6);
  const std::string end = bytes_of(*whole);
  for (std::size_t i = 0; i < saved.size(); ++i) {
    Archive archive = archive_of_checkpoint("checkpoint.h5", saved[i]);
    const std::unique_ptr<Stepper> again = restored_stepper(scene, archive);
    EXPECT_TRUE(bytes_of(*again) == saved[i]) << i;
    for (std::size_t step = i; step < 3; ++step) again->advance();
    EXPECT_TRUE(bytes_of(*again) == end) << i;
  }
}

// The mesh around the tip is made anew at each step. Curves follow an element by its number: it must stay in its place.
TEST(CrackGrowth, elements_keep_their_numbers_and_places) {
  Problem problem =
      problem_of(KEYBLOCK_SOURCE_DIR "/legacy_cases/crack_growth/cantilever_straight/cantilever_straight.json");
  problem.analysis->step_count = 3;
  const std::unique_ptr<Stepper> stepper = stepper_for(prepare(problem, "standard", {}).scene);
  Frame before = frame_now(*stepper);
  double farthest = 0;
  std::size_t renamed = 0;
  for (int step = 0; step < 3; ++step) {
    ASSERT_TRUE(std::holds_alternative<StepReport>(stepper->advance()));
    const Frame after = frame_now(*stepper);
    const ElementsByNumber known(before);
    for (std::size_t e = 0; e < after.elements.size(); ++e) {
      const ElementFrame* same = known.find(number_of(after, e));
      if (same == nullptr) continue;
      const double width = std::sqrt(2 * same->area);  // of a triangle
      farthest = std::max(farthest, distance(after.elements[e].centroid, same->centroid) / width);
      renamed += number_of(after, e) != static_cast<int>(e) ? 1U : 0U;
    }
    before = after;
  }
  EXPECT_LT(farthest, 2);  // a piece of a larger element
  EXPECT_GT(renamed, 0U);
}

// The arms of a plate are pulled apart until its crack runs into a hole: the run ends before all steps are made, and
// reports the place.
TEST(CrackGrowth, a_crack_that_ends_in_a_hole_ends_the_run_and_says_so) {
  const std::string file = support::fresh_folder("crack_hole") + "/in.json";
  support::write_text(file, R"({"keyblock": 1,
      "blocks": {"blocks": [{"outer": [[0, -1, 1], [6, -1, 1], [6, 1, 1], [0, 1, 1], [0, 0, 1]],
        "holes": [[[2.5, -0.2, 1], [2.5, 0.2, 1], [2.9, 0.2, 1], [2.9, -0.2, 1]]]}]},
      "covers": {"contact": "ignored", "mesh": {"side": 0.3, "angle": 10, "through_x": 0.0137, "through_y": 0.0071},
        "growth": {"increment": 0.2}, "cracks": [{"along": [[0, 0], [2, 0]]}],
        "tractions": [{"along": [[0, 0], [0, 1]], "y": 1}, {"along": [[0, -1], [0, 0]], "y": -1}],
        "springs": [[6, -1, 1, 0, 1e5], [6, -1, 0, 1, 1e5], [6, 1, 1, 0, 1e5]]},
      "analysis": {"step_count": 9, "time_step": 1, "allowed_displacement_ratio": 0.1, "plane_strain": true,
        "joint_materials": [{}], "block_materials": [{"density": 1, "unit_weight": 0, "youngs_modulus": 1e5,
          "poissons_ratio": 0.3, "toughness": {"mode_1": 10}}]}})");
  const RunOutcome outcome = run(prepare(problem_of(file), "standard", {}).scene, 1, {});
  EXPECT_EQ(outcome.end, RunEnd::finished);
  EXPECT_LT(outcome.steps, 5);
  EXPECT_NE(outcome.why_early.find("crack 1 to (2.5, "), std::string::npos) << outcome.why_early;
}

// The upper part of an NMM body cut by a crack at 30 degrees slides on the lower one by Coulomb's law.
TEST(CrackGrowth, a_body_cut_through_is_two_that_slide) {
  const double slope = std::tan(std::numbers::pi / 6), friction = 0.3;
  const std::string text = fmt::format(
      R"({{"keyblock": 1, "blocks": {{"blocks": [{{"outer": [[0, 0, 1], [2, 0, 1], [2, 3, 1], [0, 3, 1]]}}],
        "measured_points": [[1, 2.5, 1]]}},
      "covers": {{"mesh": {{"side": 0.5, "angle": 10}}, "cracks": [{{"along": [[-0.1, {}], [2.1, {}]]}}],
        "displacements": [{{"along": [[0, 0], [2, 0]]}}]}},
      "analysis": {{"step_count": 100, "time_step": 0.002, "velocity_carry_over": 1, "allowed_displacement_ratio": 0.1,
        "plane_strain": true, "gravity": 10, "joint_materials": [{{"friction_angle_deg": {}}}],
        "block_materials": [{{"density": 1000, "unit_weight": 10000, "youngs_modulus": 1e9,
          "poissons_ratio": 0.2}}]}}}})",
      0.6 - 0.1 * slope, 0.6 + 2.1 * slope, std::atan(friction) * 180 / std::numbers::pi);
  const std::string file = support::fresh_folder("crack_cut") + "/in.json";
  support::write_text(file, text);
  const std::unique_ptr<Stepper> stepper = stepper_for(prepare(problem_of(file), "standard", {}).scene);
  for (int step = 0; step < 100; ++step) ASSERT_TRUE(std::holds_alternative<StepReport>(stepper->advance()));
  const Point moved = stepper->state().measured_points.front().position - Point{1, 2.5};
  const double pull = 10 * (0.5 - friction * std::sqrt(0.75));
  EXPECT_NEAR(length(moved), pull * 0.2 * 0.2 / 2, 0.005 * pull * 0.2 * 0.2 / 2);
  EXPECT_NEAR(moved.y / moved.x, slope, 0.005);
}

// Cracks of all kinds through one plate: each is solved, or reported to have no room; none is lost.
TEST(CrackGrowth, random_cracks_are_solved) {
  const std::string file = KEYBLOCK_SOURCE_DIR "/legacy_cases/stress_intensity/edge_crack_05/edge_crack_05.json";
  Problem problem = problem_of(file);
  problem.covers->mesh.side = 0.25;
  unsigned state = 7;
  const auto next = [&] {
    state = state * 1664525U + 1013904223U;
    return 0.02 + 0.96 * static_cast<double>(state >> 8U) / static_cast<double>(1U << 24U);
  };
  for (int i = 0; i < 60; ++i) {
    problem.covers->cracks = {{{{0.7 * next(), 1.8 * next() - 0.9}, {0.7 * next(), 1.8 * next() - 0.9}}, {}, 0}};
    problem.covers->mesh.tip_side = i % 2 == 0 ? 0.02 : 0.1;
    const std::unique_ptr<Stepper> stepper = stepper_for(prepare(problem, "standard", {}).scene);
    const auto made = stepper->advance();
    ASSERT_TRUE(std::holds_alternative<StepReport>(made)) << std::get<StepFailure>(made).reason;
    EXPECT_LT(std::get<StepReport>(made).residual, 1e-10) << i;
  }
}

}  // namespace
}  // namespace keyblock::crack_growth_test
