// Runs with unreliable results end with 1 and a reason; similar reliable ones end with 0.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/run_doubts.hpp"

#include <gtest/gtest.h>

#include "formats/text/csv.hpp"
#include "tests/support/program.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::run_doubts_test {
namespace {

using support::fresh_folder;
using support::run_keyblock;
using support::write_text;

/// A fixed floor and a block of 1 m with its lower side at the height `low`.
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
  return run_keyblock({"run", out + "/in.json", "--profile", profile, "-o", out + "/out", "--verbose"});
}

/// A free block of 1 m and 2500 kg/m3 without weight, by Shi's rules. Only `more` acts on it: its points and its
/// analysis.
std::string lone_block(const std::string& points, const std::string& more) {
  return R"({"keyblock": 1, "blocks": {"blocks": [{"outer": [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]}], )" +
         points + R"(}, "analysis": {"velocity_carry_over": 1, "step_count": 10, "time_step": 0.01,
    "allowed_displacement_ratio": 0.5, )" +
         more + R"(, "block_materials": [{"density": 2500, "youngs_modulus": 5e9, "poissons_ratio": 0}],
    "joint_materials": [{}], "penalty_factor": 1}})";
}

void expect_trusted(const support::ProgramRun& run) {
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_EQ(run.messages.find("results are unreliable"), std::string::npos) << run.messages;
}

void expect_doubted(const support::ProgramRun& run, const std::string& why) {
  EXPECT_EQ(run.exit_code, 1) << run.messages;
  EXPECT_NE(run.messages.find("the run finished, but its results are unreliable: " + why), std::string::npos)
      << run.messages;
}

double last_of(const formats::CsvTable& table, const std::string& column) {
  return formats::csv_real(table, table.rows.back(), formats::csv_column(table, column));
}

/// Runs the block by Shi's rules. All work becomes its motion at the end; nothing else adds or takes energy. Returns
/// that energy.
double energy_of_work(const std::string& folder, const std::string& points, const std::string& more) {
  const std::string out = fresh_folder(folder);
  write_text(out + "/in.json", lone_block(points, more));
  expect_trusted(run_keyblock({"run", out + "/in.json", "--profile", "legacy", "-o", out + "/out"}));
  const formats::CsvTable ledger = formats::read_csv(formats::load(out + "/out/ledger.csv"));
  const double kinetic = last_of(ledger, "kinetic");
  EXPECT_GT(kinetic, 0);
  EXPECT_NEAR(last_of(ledger, "external"), kinetic, 1e-9 * kinetic);
  return kinetic;
}

/// Returns the messages about the energy of a free block of 1 m. It weighs 10 kN/m if `gravity` says so, and gained
/// `made` when `largest` was stored.
std::string energy_doubt(double made, double largest, const std::string& gravity = "9.81") {
  Problem problem;
  Blocks blocks;
  blocks.blocks = {support::rectangle({0, 0}, {1, 1})};
  problem.geometry = blocks;
  problem.analysis = support::plain_analysis(0.01, 1);
  problem.analysis->block_materials[0].density = 1e4 / 9.81;
  problem.analysis->block_materials[0].unit_weight = 1e4;
  const Prepared prepared = prepare(problem, "standard", {{"gravity", gravity}});
  RunRecord record;
  record.outcome.ledger_scope.has_flows = true;
  record.totals.area_share = 1;
  record.ledger_sums.is_begun = true;
  record.ledger_sums.made = made;
  record.ledger_sums.largest_stored = largest;
  Frame frame;
  frame.elements.resize(1);
  frame.elements[0].area = 1;
  const Warnings doubts = judged(prepared, record, frame, {}, {}).doubts;
  return doubts.empty() ? "" : doubts.front().sentence;
}

}  // namespace

// 10 kN/m over a ten-thousandth of 1 m is 1 J/m, of which 0.01 is allowed.
TEST(RunDoubts, energy_is_held_against_what_weight_does_over_a_small_way_where_little_is_stored) {
  EXPECT_EQ(energy_doubt(0.009, 0.1), "");
  EXPECT_EQ(energy_doubt(0.011, 0.1),
            "energy came from nothing: 0.011 of the work of all weights over 0.0001 of a block's size; limit 0.01 "
            "(energy_limit)");
  EXPECT_EQ(energy_doubt(0.009, 0.1, "0"),
            "energy came from nothing: 0.09 of the largest stored energy; limit 0.01 (energy_limit)")
      << "without weight";
}

// 11 of 100 steps out of balance by more than 1e-4 are a doubt, 10 are not; Shi's rules have no such residual.
TEST(RunDoubts, forces_out_of_balance_in_more_than_a_tenth_of_the_steps_are_doubted) {
  const auto doubt = [](int unbalanced, const std::string& profile) -> std::string {
    Problem problem;
    Blocks blocks;
    blocks.blocks = {support::rectangle({0, 0}, {1, 1})};
    problem.geometry = blocks;
    problem.analysis = support::plain_analysis(0.01, 100);
    RunRecord record;
    for (int i = 0; i < 100; ++i) {
      StepReport report;
      report.residual = i < unbalanced ? 2e-4 : 5e-5;
      record.totals.add(report);
    }
    Frame frame;
    frame.elements.resize(1);
    frame.elements[0].area = 1;
    const Warnings doubts = judged(prepare(problem, profile, {}), record, frame, {}, {}).doubts;
    return doubts.empty() ? "" : doubts.front().name;
  };
  EXPECT_EQ(doubt(11, "standard"), "unbalanced_steps");
  EXPECT_EQ(doubt(10, "standard"), "");
  EXPECT_EQ(doubt(11, "legacy"), "");
}

// Slid by a millimetre, 10 J/m: one part in fifty is reported, at any speed.
TEST(RunDoubts, energy_of_what_slid_is_held_against_the_largest_there_was) {
  EXPECT_EQ(energy_doubt(0.2, 10),
            "energy came from nothing: 0.02 of the largest stored energy; limit 0.01 (energy_limit)");
  EXPECT_EQ(energy_doubt(0.09, 10), "");
}

// Stress that relaxes at the start leaves round-off alone; its energy of before is what energies are compared with.
TEST(RunDoubts, stress_that_relaxes_without_weight_is_trusted) {
  for (const int far : {0, 10000}) {
    const auto corner = [&](int x, int y) {
      return "[" + std::to_string(x + far) + ", " + std::to_string(y + far) + ", 1]";
    };
    const auto square = [&](int material, int left, int low, int right, int high) {
      return "{\"material\": " + std::to_string(material) + ", \"outer\": [" + corner(left, low) + ", " +
             corner(right, low) + ", " + corner(right, high) + ", " + corner(left, high) + "]}";
    };
    const std::string text = R"({"keyblock": 1, "blocks": {"blocks": [)" + square(1, -2, -1, 3, 0) + ", " +
                             square(2, 0, 0, 1, 1) + ", " + square(2, 0, 1, 1, 2) + R"(], "fixed_points": [)" +
                             corner(-2, -1) + ", " + corner(3, -1) + R"(]}, "analysis": {"velocity_carry_over": 1,
      "step_count": 20, "time_step": 0.002, "allowed_displacement_ratio": 0.05, "gravity": 0, "block_materials": [
      {"density": 2500, "youngs_modulus": 5e9, "poissons_ratio": 0.25},
      {"density": 2500, "youngs_modulus": 5e9, "poissons_ratio": 0.25, "initial_stress": [-1e6, -1e6, 0]}],
      "joint_materials": [{"friction_angle_deg": 30, "cohesion": 0, "tensile_strength": 0}]}})";
    expect_trusted(run_of("run_doubts_stress", text, "standard"));
  }
}

TEST(RunDoubts, a_block_at_rest_on_a_floor_is_trusted) {
  for (const char* profile : {"standard", "legacy"})
    expect_trusted(run_of("doubt_none", block_over_floor("0", "1", "5e9"), profile));
}

// Half of it is in the floor initially: springs of legacy do not push it out in five steps.
TEST(RunDoubts, blocks_that_overlap_at_the_end_are_doubted_whatever_the_contacts_saw) {
  expect_doubted(run_of("doubt_overlap", block_over_floor("-0.5", "0.5", "5e9"), "legacy"),
                 "block 1 and block 2 share 0.5 of the smaller one's area at the end");
}

// Its weight presses a block of E = 2e4 by γ h / 2E = 0.6 of its height on average, before the first step.
TEST(RunDoubts, what_the_start_crushes_counts) {
  expect_doubted(run_of("doubt_soft", block_over_floor("0", "1", "2e4"), "standard"), "block 2 was compressed to 0.3");
}

// Its weight acts suddenly on a block of E = 5e4, whose mean strain then oscillates between 0 and twice γ h / 2E =
// 0.25. Its area is nearly the unloaded one again when the run ends.
TEST(RunDoubts, what_was_crushed_between_start_and_end_counts) {
  std::string text = block_over_floor("0", "1", "5e4");
  const std::string steps = R"("step_count": 5)";
  text.replace(text.find(steps), steps.size(), R"("step_count": 900)");
  const std::string folder = fresh_folder("doubt_swings");
  write_text(folder + "/in.json", text);
  const support::ProgramRun run = run_keyblock(
      {"run", folder + "/in.json", "--set", "start=sudden", "--set", "strain_damping=none", "-o", folder + "/out"});
  expect_doubted(run, "block 2 was compressed to 0.5");
}

// Under half its weight on average, 12263 N/m2, it shortens by a quarter, and its middle goes down by half of that.
TEST(RunDoubts, a_start_that_moves_a_block_by_a_tenth_of_its_size_is_doubted) {
  expect_doubted(run_of("doubt_moved", block_over_floor("0", "1", "5e4"), "standard"), "the initial state moves block");
}

// A cantilever of 10 m bends by w L⁴/(8 E I) = 7 cm, a sixth of the side of its elements, and begins so. A square on a
// frictionless slope of 45 degrees slides, which is reported and no fault.
TEST(RunDoubts, a_start_at_rest_may_bend_bodies_on_covers) {
  const auto case_of = [](const std::string& blocks, const std::string& held) {
    return R"({"keyblock": 1, "blocks": {"blocks": [)" + blocks +
           R"(]}, "covers": {"mesh": {"side": 0.5}, "displacements": [{"along": )" + held +
           R"(}]}, "analysis": {"velocity_carry_over": 1, "step_count": 5, "time_step": 0.001,
    "allowed_displacement_ratio": 0.05, "gravity": 9.81, "joint_materials": [{}], "block_materials": [
    {"density": 2500, "unit_weight": 24525, "youngs_modulus": 5e9, "poissons_ratio": 0.2}]},
    "run": {"set": {"start": "compatible"}}})";
  };
  const support::ProgramRun beam =
      run_of("doubt_bent", case_of(R"({"outer": [[0, 0, 1], [10, 0, 1], [10, 1, 1], [0, 1, 1]]})", "[[0, 1], [0, 0]]"),
             "standard");
  expect_trusted(beam);
  EXPECT_NE(beam.messages.find("initial state: at t = 0 stresses and contact forces balance the loads"),
            std::string::npos)
      << beam.messages;
  EXPECT_EQ(beam.messages.find("start_without_rest"), std::string::npos) << beam.messages;
  const support::ProgramRun slope = run_of("doubt_slope",
                                           case_of(R"({"outer": [[0, 0, 1], [4, 0, 1], [0, 4, 1]]},
    {"outer": [[2, 2, 1], [2, 3, 1], [1, 3, 1]]})",
                                                   "[[0, 0], [4, 0]]"),
                                           "standard");
  expect_trusted(slope);
  EXPECT_NE(slope.messages.find("[start_without_rest]"), std::string::npos) << slope.messages;
}

// 1000 N for 0.1 s on 2500 kg: a = 0.4, v = 0.04, ½ m v² = 2 J, and F times its way of ½ a t² = 2 mm is as much.
TEST(RunDoubts, the_work_of_loads_is_in_the_books_of_the_old_rules) {
  EXPECT_NEAR(energy_of_work("doubt_load", R"("loading_points": [[0.5, 0.5, 1]])",
                             R"("point_loads": [[[0, 1000, 0], [1, 1000, 0]]])"),
              2, 1e-9);
}

TEST(RunDoubts, the_work_of_an_acceleration_is_in_the_books_of_the_old_rules) {
  EXPECT_NEAR(energy_of_work("doubt_shaken", R"("bolts": [])", R"("body_acceleration": [[0, 0.4, 0], [1, 0.4, 0]])"), 2,
              1e-9);
}

// Driven at its centroid it neither turns nor strains.
TEST(RunDoubts, the_work_of_driven_points_is_in_the_books_of_the_old_rules) {
  energy_of_work("doubt_driven", R"("fixed_points": [[0.5, 0.5, 1]])",
                 R"("fixed_point_motions": [[[0, 0, 0], [0.05, 0.01, 0], [1, 0.2, 0.1]]])");
}

// The shaken slope of the fronts: under Shi's rules its blocks fly apart, without any other sign. After these steps the
// last digit decides if a block moves too far even for the smallest step.
TEST(RunDoubts, blocks_that_fly_apart_under_given_accelerations_are_doubted) {
  const std::string folder = fresh_folder("doubt_slope");
  const std::string slope = KEYBLOCK_SOURCE_DIR "/legacy_cases/fronts/slope.json";
  expect_doubted(run_keyblock({"run", slope, "--profile", "legacy", "--set", "steps=1000", "-o", folder + "/out"}),
                 "energy came from nothing: ");
}

}  // namespace keyblock::run_doubts_test
