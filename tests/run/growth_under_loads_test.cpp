// Cracks that grow under given loads: energy, momentum, checkpoints, blocks beside them, cracks that start.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "formats/case.hpp"
#include "formats/registry.hpp"
#include "model/continuum.hpp"
#include "result/ledger.hpp"
#include "run/checkpoint.hpp"
#include "run/prepare.hpp"
#include "run/steppers.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::growth_under_loads_test {
namespace {

constexpr double kYoung = 1e5, kPoisson = 0.3, kToughness = 10;
constexpr double kEnergy = kToughness * kToughness * (1 - kPoisson * kPoisson) / kYoung;  // Γ = K²/E' (Irwin 1957)

std::string file_of(const std::string& name, const std::string& text) {
  const std::string file = support::fresh_folder("growth_under_loads_" + name) + "/in.json";
  support::write_text(file, text);
  return file;
}

Scene scene_of(const std::string& file) {
  return prepare(formats::load_case({file}).problem, "standard", {}).scene;
}

std::string bytes_of(Stepper& stepper) {
  Archive archive;
  stepper.save(archive);
  return checkpoint_bytes(archive);
}

// Arms of a double cantilever that four points drive apart, slowly for waves that cross it in 0.1.
std::string cantilever(int steps, double time_step, double tip_side) {
  return fmt::format(
      R"({{"keyblock": 1,
      "blocks": {{"blocks": [{{"outer": [[0, -1, 1], [8, -1, 1], [8, 1, 1], [0, 1, 1]]}}],
        "fixed_points": [[0.05, 0.5, 1], [0.05, -0.5, 1]]}},
      "covers": {{"mesh": {{"side": 0.5, "angle": 10, "tip_side": {}}}, "cracks": [{{"along": [[0, 0], [2, 0]]}}],
        "growth": {{"increment": 0.4}}}},
      "analysis": {{"step_count": {}, "time_step": {}, "velocity_carry_over": 1, "allowed_displacement_ratio": 0.1,
        "plane_strain": true, "gravity": 0, "joint_materials": [{{}}],
        "fixed_point_motions": [[[0, 0, 0], [10, 0, 0.01]], [[0, 0, 0], [10, 0, -0.01]]],
        "block_materials": [{{"density": 1, "unit_weight": 0, "youngs_modulus": {}, "poissons_ratio": {},
          "toughness": {{"mode_1": {}}}}}]}}}})",
      tip_side, steps, time_step, kYoung, kPoisson, kToughness);
}

// Each increment takes its energy, and the energy balance has no other term for it.
TEST(GrowthUnderLoads, takes_the_energy_of_fracture) {
  const std::unique_ptr<Stepper> stepper = stepper_for(scene_of(file_of("energy", cantilever(40, 0.04, 0.1))));
  LedgerSums sums;
  sums.add(stepper->ledger());
  for (int step = 0; step < 40; ++step) {
    ASSERT_TRUE(std::holds_alternative<StepReport>(stepper->advance())) << step;
    sums.add(stepper->ledger());
  }
  ASSERT_EQ(stepper->tips().size(), 1U);
  const double grown = stepper->tips().front().length - 2;
  ASSERT_GT(grown, 0.75) << "no growth to speak of";
  // In statics the opening of 3.2e-3 has brought the tip to a: δ = 2 K (3.46 a + 2.38 h)²/(10.38 h^1.5 E'), from the
  // formula for K by G = P²/2 dC/da (Kanninen 1973).
  const double at_rest =
      (std::sqrt(3.2e-3 * 10.38 * kYoung / (1 - kPoisson * kPoisson) / (2 * kToughness)) - 2.38) / 3.46;
  EXPECT_NEAR(2 + grown, at_rest, 0.4) << "an increment";
  EXPECT_LT(sums.energy_closure(), 1e-8);
  const double taken = stepper->ledger().flow.fracture;
  // The faces of the last increment may still be parting.
  EXPECT_LE(taken, 1.0001 * kEnergy * grown);
  EXPECT_GE(taken, 0.99 * kEnergy * (grown - 0.4));
  EXPECT_NEAR(stepper->tips().front().at.y, 0, 0.2) << "half an increment";
}

// Left in rest, under load, before its first increment, while the faces of that part, and before two more.
TEST(GrowthUnderLoads, left_at_any_step_it_goes_on_to_the_same_bytes) {
  constexpr int steps = 30;
  constexpr int kApart = 3;
  const Scene scene = scene_of(file_of("bytes", cantilever(steps, 0.04, 0.1)));
  const std::unique_ptr<Stepper> whole = stepper_for(scene);
  std::vector<std::string> saved;
  for (int step = 0; step < steps; ++step) {
    if (step % kApart == 0) saved.push_back(bytes_of(*whole));
    ASSERT_TRUE(std::holds_alternative<StepReport>(whole->advance()));
  }
  ASSERT_GT(whole->tips().front().length, 3.1) << "three increments";
  saved.push_back(bytes_of(*whole));
  for (const std::size_t i : {0U, 4U, 6U, 7U, 9U}) {
    Archive archive = archive_of_checkpoint("checkpoint.h5", saved[i]);
    const std::unique_ptr<Stepper> again = restored_stepper(scene, archive);
    EXPECT_TRUE(bytes_of(*again) == saved[i]) << i;
    for (int step = 0; step < kApart; ++step) again->advance();
    EXPECT_TRUE(bytes_of(*again) == saved[i + 1]) << i;
  }
}

// A free plate that two equal pulls tear: no support takes momentum.
TEST(GrowthUnderLoads, keeps_momentum_of_a_free_plate) {
  const std::string text = fmt::format(
      R"({{"keyblock": 1, "blocks": {{"blocks": [{{"outer": [[-3, -2, 1], [3, -2, 1], [3, 2, 1], [-3, 2, 1]]}}]}},
      "covers": {{"mesh": {{"side": 0.6, "angle": 10, "tip_side": 0.15}},
        "cracks": [{{"along": [[-0.8, 0.1], [0.8, -0.1]]}}],
        "growth": {{"increment": 0.3}},
        "tractions": [{{"along": [[3, 2], [-3, 2]], "y": 8}}, {{"along": [[-3, -2], [3, -2]], "y": -8}}]}},
      "analysis": {{"step_count": 30, "time_step": 0.004, "velocity_carry_over": 1, "allowed_displacement_ratio": 0.1,
        "plane_strain": true, "gravity": 0, "joint_materials": [{{}}],
        "block_materials": [{{"density": 1, "unit_weight": 0, "youngs_modulus": {}, "poissons_ratio": {},
          "initial_velocity": [3, 2, 1], "toughness": {{"mode_1": {}}}}}]}}}})",
      kYoung, kPoisson, kToughness);
  const std::unique_ptr<Stepper> stepper = stepper_for(scene_of(file_of("momentum", text)));
  LedgerSums sums;
  sums.add(stepper->ledger());
  double longest = 0;
  for (int step = 0; step < 30; ++step) {
    ASSERT_TRUE(std::holds_alternative<StepReport>(stepper->advance())) << step;
    sums.add(stepper->ledger());
    for (const TipState& tip : stepper->tips()) longest = std::max(longest, tip.length);
  }
  EXPECT_GT(longest, 2.1);
  EXPECT_LT(sums.energy_closure(), 1e-8);
  EXPECT_LT(sums.linear_momentum_closure(), 1e-10);
  EXPECT_LT(sums.angular_momentum_closure(), 1e-10);
}

// A notched beam between three blocks is broken in two.
TEST(GrowthUnderLoads, a_beam_on_blocks_breaks_in_two) {
  const std::string text =
      R"({"keyblock": 1,
      "blocks": {"blocks": [{"outer": [[-0.22, -0.05, 1], [0.22, -0.05, 1], [0.22, 0.05, 1], [-0.22, 0.05, 1]]},
        {"outer": [[-0.21, -0.07, 1], [-0.19, -0.07, 1], [-0.197, -0.05, 1], [-0.203, -0.05, 1]], "material": 2},
        {"outer": [[0.19, -0.07, 1], [0.21, -0.07, 1], [0.203, -0.05, 1], [0.197, -0.05, 1]], "material": 2},
        {"outer": [[-0.003, 0.05, 1], [0.003, 0.05, 1], [0.01, 0.07, 1], [-0.01, 0.07, 1]], "material": 2}],
        "fixed_points": [[-0.205, -0.068, 2], [-0.195, -0.068, 2], [0.195, -0.068, 3], [0.205, -0.068, 3],
          [-0.006, 0.068, 4], [0.006, 0.068, 4]]},
      "covers": {"mesh": {"side": 0.04, "angle": 10, "materials": [[1]]}, "cracks": [{"along": [[0, -0.05], [0, 0]]}],
        "growth": {"increment": 0.012}},
      "analysis": {"velocity_carry_over": 1, "step_count": 150, "time_step": 1e-4, "allowed_displacement_ratio": 0.1,
        "plane_strain": true, "gravity": 9.81, "joint_materials": [{}],
        "fixed_point_motions": [[], [], [], [], [[0, 0, 0], [0.01, 0, -3e-4]], [[0, 0, 0], [0.01, 0, -3e-4]]],
        "block_materials": [{"density": 2400, "unit_weight": 0, "youngs_modulus": 3e10, "poissons_ratio": 0.2,
            "toughness": {"mode_1": 1e6}},
          {"density": 7800, "unit_weight": 0, "youngs_modulus": 2e11, "poissons_ratio": 0.3}]}})";
  const std::unique_ptr<Stepper> stepper = stepper_for(scene_of(file_of("beam", text)));
  LedgerSums sums;
  sums.add(stepper->ledger());
  int parted = 0;
  for (int step = 0; step < 150 && parted < 5; ++step) {
    ASSERT_TRUE(std::holds_alternative<StepReport>(stepper->advance())) << step;
    sums.add(stepper->ledger());
    if (stepper->tips().empty()) ++parted;
  }
  EXPECT_TRUE(stepper->tips().empty()) << "it is connected";
  EXPECT_LT(sums.energy_closure(), 1e-8);
  const double energy = 1e6 * 1e6 * (1 - 0.04) / 3e10 * 0.05;
  EXPECT_NEAR(stepper->ledger().flow.fracture, energy,
              0.25 * energy);  // the last bit breaks under the block's pressure
}

// Sudden loads start cracks beside the sides they pull at; the ends of some lie beyond these.
TEST(GrowthUnderLoads, a_crack_that_starts_beside_a_line_parts_within_the_rock) {
  const std::string text = R"({"keyblock": 1, "units": {"length": "ft", "stress": "psi", "time": "s"},
      "blocks": {"blocks": [{"outer": [[-3, -2, 1], [3, -2, 1], [3, 2, 1], [-3, 2, 1]]}]},
      "covers": {"mesh": {"side": 0.8, "angle": 10, "tip_side": 0.2}, "growth": {"increment": 0.8, "loads": "given"},
        "tractions": [{"along": [[3, 2], [-3, 2]], "y": "120 psi"}, {"along": [[-3, -2], [3, -2]], "y": "-120 psi"}]},
      "analysis": {"step_count": 3, "time_step": 2e-4, "velocity_carry_over": 1, "allowed_displacement_ratio": 0.1,
        "plane_strain": true, "gravity": 0, "joint_materials": [{}],
        "block_materials": [{"density": "150 lb/ft3", "youngs_modulus": "3e6 psi", "poissons_ratio": 0.2,
          "toughness": {"mode_1": "1 MPa√m", "tensile_strength": "116 psi"}}]}})";
  const std::unique_ptr<Stepper> stepper = stepper_for(scene_of(file_of("beside", text)));
  LedgerSums sums;
  sums.add(stepper->ledger());
  bool reaches_beyond = false;
  for (int step = 0; step < 3; ++step) {
    const auto made = stepper->advance();
    ASSERT_TRUE(std::holds_alternative<StepReport>(made)) << step << ": " << std::get<StepFailure>(made).reason;
    sums.add(stepper->ledger());
    for (const CrackPlan& crack : stepper->model().continuum->cracks)
      for (const Point end : crack.along) reaches_beyond = reaches_beyond || std::abs(end.x) > 3 || std::abs(end.y) > 2;
  }
  EXPECT_TRUE(reaches_beyond);
  EXPECT_LT(sums.energy_closure(), 1e-8);
}

// In statics each step has one increment: a crack that would propagate further under the last load is reported.
TEST(GrowthUnderLoads, a_run_at_rest_that_ends_with_tips_that_go_on_is_not_trusted) {
  // K_I = s √(π a) of an infinite plate (Irwin 1957) with a = 0.8 reaches the toughness of 10 at s = 6.3.
  for (const double load : {3.0, 12.0}) {
    const std::string file = file_of(
        "at_rest",
        fmt::format(
            R"({{"keyblock": 1, "blocks": {{"blocks": [{{"outer": [[-3, -2, 1], [3, -2, 1], [3, 2, 1], [-3, 2, 1]]}}]}},
      "covers": {{"mesh": {{"side": 0.6, "angle": 10, "tip_side": 0.06}},
        "cracks": [{{"along": [[-0.8, 0.1], [0.8, -0.1]]}}],
        "growth": {{"increment": 0.3, "loads": "given"}},
        "springs": [[0, -2, 1, 0, 1e4], [0, -2, 0, 1, 1e4], [0, 2, 1, 0, 1e4]],
        "tractions": [{{"along": [[3, 2], [-3, 2]], "y": {0}}}, {{"along": [[-3, -2], [3, -2]], "y": -{0}}}]}},
      "analysis": {{"step_count": 2, "time_step": 1, "velocity_carry_over": 0, "allowed_displacement_ratio": 0.1,
        "plane_strain": true, "gravity": 0, "joint_materials": [{{}}],
        "block_materials": [{{"density": 1, "unit_weight": 0, "youngs_modulus": {1}, "poissons_ratio": {2},
          "toughness": {{"mode_1": {3}}}}}]}}}})",
            load, kYoung, kPoisson, kToughness));
    const support::ProgramRun run = support::run_keyblock({"run", file, "-o", file + ".out", "--force"});
    const bool goes_on = run.messages.find("still extends under the loads of the last step") != std::string::npos;
    EXPECT_EQ(run.exit_code, load > 6 ? 1 : 0) << run.messages;
    EXPECT_EQ(goes_on, load > 6) << run.messages;
  }
}

// A plate with an inclined edge crack, under a tension that lets every step propagate.
std::string pulled_plate(const char* loads, double pull, const char* corrector) {
  return fmt::format(
      R"({{"keyblock": 1, "blocks": {{"blocks": [{{"outer": [[0, -2, 1], [3, -2, 1], [3, 2, 1], [0, 2, 1]]}}]}},
      "covers": {{"mesh": {{"side": 0.4, "angle": 10}}, "cracks": [{{"along": [[0, 0], [0.8, 0.5]]}}],
        "growth": {{"increment": 0.2, "loads": "{}", "corrector": {}}},
        "tractions": [{{"along": [[0, 2], [3, 2]], "y": {}}}, {{"along": [[0, -2], [3, -2]], "y": {}}}],
        "springs": [[3, -2, 1, 0, 1e6], [3, -2, 0, 1, 1e6], [3, 2, 1, 0, 1e6]]}},
      "analysis": {{"step_count": 4, "time_step": 1, "velocity_carry_over": 0, "allowed_displacement_ratio": 0.1,
        "plane_strain": true, "gravity": 0, "joint_materials": [{{}}],
        "block_materials": [{{"density": 1, "unit_weight": 0, "youngs_modulus": 1e6, "poissons_ratio": 0.3,
          "toughness": {{"mode_1": 1}}}}]}}}})",
      loads, corrector, pull, -pull);
}

constexpr std::size_t kPathSteps = 3;

std::vector<Point> path_of(const std::string& text) {
  const std::unique_ptr<Stepper> stepper = stepper_for(scene_of(file_of("path", text)));
  std::vector<Point> path;
  for (std::size_t step = 0; step < kPathSteps; ++step) {
    if (!std::holds_alternative<StepReport>(stepper->advance())) return {};
    path.push_back(stepper->tips().front().at);
  }
  return path;
}

// The path does not depend on the surplus of the load.
TEST(GrowthUnderLoads, goes_at_rest_where_scaled_loads_lead_it) {
  const std::vector<Point> scaled = path_of(pulled_plate("scaled", 1, "true"));
  const std::vector<Point> given = path_of(pulled_plate("given", 3, "true"));
  const std::vector<Point> uncorrected = path_of(pulled_plate("given", 3, "false"));
  for (const auto* path : {&scaled, &given, &uncorrected}) ASSERT_EQ(path->size(), kPathSteps);
  EXPECT_GT(distance(scaled.front(), scaled.back()), 0.35);
  for (std::size_t i = 0; i < kPathSteps; ++i) EXPECT_LT(distance(scaled[i], given[i]), 1e-3) << i;
  EXPECT_GT(distance(given.back(), uncorrected.back()), 2e-3) << "a correction, twice the tolerance of the paths above";
}

// A plate pressed at its ends, narrowest at half its height: the first crack starts in shear at the strength of
// Coulomb, 2 c cos φ / (1 - sin φ), at 45° + φ/2 to the horizontal.
TEST(GrowthUnderLoads, a_crack_starts_in_shear_as_coulomb_says) {
  const double friction = 30, cohesion = 5;
  const std::string text = fmt::format(
      R"({{"keyblock": 1, "blocks": {{"blocks": [{{"outer": [[-2, -4, 1], [2, -4, 1], [1.99, 0, 1], [2, 4, 1],
        [-2, 4, 1],
        [-1.99, 0, 1]]}}]}},
      "covers": {{"mesh": {{"side": 0.5, "angle": 10}}, "growth": {{"increment": 0.4}},
        "tractions": [{{"along": [[2, 4], [-2, 4]], "y": -1}}, {{"along": [[-2, -4], [2, -4]], "y": 1}}],
        "springs": [[0, -4, 1, 0, 1e4], [0, -4, 0, 1, 1e4], [0, 4, 1, 0, 1e4]]}},
      "analysis": {{"step_count": 2, "time_step": 1, "velocity_carry_over": 0, "allowed_displacement_ratio": 0.1,
        "plane_strain": true, "gravity": 0, "joint_materials": [{{"friction_angle_deg": {0}}}],
        "block_materials": [{{"density": 1, "unit_weight": 0, "youngs_modulus": 1e5, "poissons_ratio": 0.3,
          "toughness": {{"mode_1": 1e3, "mode_2": {1}, "cohesion": {2}, "friction_deg": {0}}}}}]}}}})",
      friction, cohesion * std::sqrt(std::numbers::pi * 1.2), cohesion);
  const std::unique_ptr<Stepper> stepper = stepper_for(scene_of(file_of("shear", text)));
  ASSERT_TRUE(std::holds_alternative<StepReport>(stepper->advance()));
  const double phi = friction * std::numbers::pi / 180;
  const double strength = 2 * cohesion * std::cos(phi) / (1 - std::sin(phi));
  EXPECT_NEAR(stepper->load_factor(), strength, 0.02 * strength);
  const auto second = stepper->advance();
  ASSERT_TRUE(std::holds_alternative<StepReport>(second)) << std::get<StepFailure>(second).reason;
  ASSERT_FALSE(stepper->model().continuum->cracks.empty());
  const CrackPlan& crack = stepper->model().continuum->cracks.front();
  EXPECT_TRUE(crack.is_shear);
  const Point way = crack.along.back() - crack.along.front();
  EXPECT_NEAR(length(way), 2.4, 1e-6);
  EXPECT_NEAR(std::atan2(std::abs(way.y), std::abs(way.x)) * 180 / std::numbers::pi, 45 + friction / 2, 1.5);
}

}  // namespace
}  // namespace keyblock::growth_under_loads_test
