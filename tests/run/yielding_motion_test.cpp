// Elastoplastic rock in time and under contact: effect of an impact, closed energy balances, and the friction of NMM
// bodies under impact.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "formats/registry.hpp"
#include "formats/text/csv.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::yielding_motion_test {
namespace {

using support::fresh_folder;
using support::read_text;
using support::run_keyblock;
using support::write_text;

/// Blocks on a fixed floor of material 2; those of material 1 are NMM bodies.
std::string scene(const std::string& blocks, const std::string& points, const std::string& materials, double friction,
                  double dt, int steps, const std::string& mesh) {
  return fmt::format(R"({{"keyblock": 1, "blocks": {{"blocks": [{}], {}}}, "covers": {{"mesh": {}}}, "analysis": {{
    "velocity_carry_over": 1, "step_count": {}, "time_step": {}, "allowed_displacement_ratio": 1, "plane_strain": true,
    "block_materials": [{}], "joint_materials": [{{"friction_angle_deg": {}}}]}}}})",
                     blocks, points, mesh, steps, dt, materials, friction);
}

const std::string kFloor = R"({"material": 2, "outer": [[-1, -1, 1], [2, -1, 1], [2, 0, 1], [-1, 0, 1]]})";
const std::string kFloorHeld = R"("fixed_points": [[-0.9, -0.5, 1], [1.9, -0.5, 1]])";
const std::string kStiff = R"({"density": 2600, "unit_weight": 0, "youngs_modulus": 5e10, "poissons_ratio": 0.25})";

struct Done {
  int exit_code = 0;
  std::string messages;
  nlohmann::json report;
  std::string folder;

  /// Returns the column of this name in every row.
  std::vector<double> column(const std::string& name) const {
    const formats::CsvTable table = formats::read_csv(formats::load(folder + "/out/ledger.csv"));
    const std::size_t place = formats::csv_column(table, name);
    std::vector<double> values;
    for (const formats::CsvRow& row : table.rows) values.push_back(formats::csv_real(table, row, place));
    return values;
  }
  double closure() const { return report["ledger"]["closure"]["energy"]; }
};

Done run_of(const std::string& name, const std::string& text) {
  const std::string folder = fresh_folder("yielding_motion_" + name);
  write_text(folder + "/in.json", text);
  const auto run = run_keyblock({"run", folder + "/in.json", "-o", folder + "/out", "--force"});
  Done done{run.exit_code, run.messages, {}, folder};
  if (run.exit_code != 3) done.report = nlohmann::json::parse(read_text(folder + "/out/run.json"));
  return done;
}

/// A column of 1 by 2 that falls on the floor at 2 per time.
std::string falling_column(const std::string& strength, double dt, int steps) {
  return scene(kFloor + R"(, {"material": 1, "outer": [[0, 0, 1], [1, 0, 1], [1, 2, 1], [0, 2, 1]]})", kFloorHeld,
               R"({"density": 2600, "unit_weight": 25506, "youngs_modulus": 5e9, "poissons_ratio": 0.25,
                 "initial_velocity": [0, -2, 0])" +
                   strength + "}, " + kStiff,
               20, dt, steps, R"({"side": 0.3, "materials": [[1]]})");
}

}  // namespace

// A beam of rock that flows under its weight in one step of a second: nothing is in contact, and no message blames a
// contact.
TEST(YieldingMotion, a_step_too_long_for_the_flow_says_so) {
  const std::string folder = fresh_folder("yielding_motion_too_long");
  ASSERT_EQ(run_keyblock({"new", "beam", "-o", folder + "/beam.json"}).exit_code, 0);
  std::string text = read_text(folder + "/beam.json");
  const std::string rock = R"("like": "sandstone")";
  text.insert(text.find(rock) + rock.size(),
              R"(, "strength": {"cohesion": 1e6, "friction_deg": 20, "dilation_deg": 30})");
  write_text(folder + "/beam.json", text);
  const auto run = run_keyblock(
      {"run", folder + "/beam.json", "-o", folder + "/out", "--set", "motion=dynamic", "--set", "start=sudden"});
  EXPECT_EQ(run.exit_code, 4) << run.messages;
  EXPECT_NE(run.messages.find("no motion balances the step, in which nothing touches: too many iterations"),
            std::string::npos)
      << run.messages;
}

// The symmetric part of a tangent of non-associated flow has no factorisation in statics but with much inertia: it took
// 556 linear solves per step on covers and 21 on a block.
TEST(YieldingMotion, plates_press_rock_that_flows_without_dilation_in_few_systems) {
  for (const auto& [on_covers, most] : {std::pair{true, 60}, {false, 3}}) {
    const std::string plates = kFloor + R"(,
      {"material": 1, "outer": [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]},
      {"material": 2, "outer": [[-1, 1, 1], [2, 1, 1], [2, 2, 1], [-1, 2, 1]]})";
    const std::string motion = "[[0, 0, 0], [10, 0, -0.01]]";
    const std::string text = fmt::format(
        R"({{"keyblock": 1, "blocks": {{"blocks": [{}],
        "fixed_points": [[-0.9, -0.5, 1], [1.9, -0.5, 1], [-0.9, 1.5, 3], [1.9, 1.5, 3]]}}, {}
        "analysis": {{"velocity_carry_over": 0, "step_count": 10, "time_step": 1, "allowed_displacement_ratio": 1,
        "plane_strain": true, "fixed_point_motions": [[], [], {}, {}],
        "block_materials": [{{"density": 1, "unit_weight": 0, "youngs_modulus": 1e4, "poissons_ratio": 0.3,
        "strength": {{"cohesion": 10, "friction_deg": 30, "dilation_deg": 0}}}},
        {{"density": 1, "unit_weight": 0, "youngs_modulus": 1e6, "poissons_ratio": 0.3}}],
        "joint_materials": [{{"friction_angle_deg": 0}}]}}}})",
        plates, on_covers ? R"("covers": {"mesh": {"side": 0.35, "materials": [[1]]}}, )" : "", motion, motion);
    const Done done = run_of("pressed", text);
    EXPECT_EQ(done.exit_code, 0) << done.messages;
    EXPECT_GT(done.report["plastic"]["yielding_fraction"], 0.999);
    EXPECT_LT(done.report["counts"]["passes"], 10 * most);
  }
}

TEST(YieldingMotion, what_swings_too_slowly_is_told_before_the_run) {
  const std::string strength = R"(, "strength": {"cohesion": 2e6, "friction_deg": 30})";
  const Done done = run_of("soft", falling_column(strength, 5e-4, 2));
  EXPECT_NE(done.messages.find("on the case: soft_patterns"), std::string::npos) << done.messages;
  EXPECT_NE(done.report["warnings"].dump().find("About three in four of"), std::string::npos) << done.messages;
  const Done elastic = run_of("not_soft", falling_column("", 5e-4, 2));
  EXPECT_EQ(elastic.messages.find("soft_patterns"), std::string::npos) << elastic.messages;
}

// Friction at the end of a step that reverses the velocity would push: that created 3 % of the energy.
TEST(YieldingMotion, a_column_on_covers_that_hits_a_floor_makes_no_energy) {
  for (const auto& [dt, steps] : {std::pair{5e-4, 100}, {1e-4, 400}}) {
    const Done done = run_of("elastic", falling_column("", dt, steps));
    EXPECT_EQ(done.exit_code, 0) << done.messages;
    EXPECT_LT(done.closure(), 1e-10);
    for (const double friction : done.column("friction")) EXPECT_GT(friction, -1e-6 * 5200);
  }
}

TEST(YieldingMotion, a_column_that_yields_as_it_hits_closes_its_books) {
  for (const std::string strength : {R"({"surface": "von_mises", "yield_stress": 5e6})",
                                     R"({"cohesion": 2e6, "friction_deg": 30, "dilation_deg": 0})"}) {
    const Done done = run_of("hit", falling_column(R"(, "strength": )" + strength, 5e-4, 100));
    EXPECT_EQ(done.exit_code, 0) << done.messages;
    EXPECT_LT(done.closure(), 1e-8);
    const std::vector<double> plastic = done.column("plastic");
    EXPECT_GT(plastic.back(), 0.3 * 10400);  // of the energy of the fall
    EXPECT_TRUE(std::ranges::is_sorted(plastic));
  }
}

// A weight that falls on a weak pillar: the energy of the fall becomes plastic work under the strength 2 c of Tresca.
// On covers its nominal stress is T/λ with the logarithmic strain: E + M g s = T L ln(1/λ) - T² L/(2 E').
TEST(YieldingMotion, a_pillar_under_a_falling_weight_sinks_by_the_energy_of_the_fall) {
  constexpr double kMass = 20000, kGravity = 9.81, kFall = 0.501, kStrength = 2e6, kLength = 2;
  const double modulus = 1e9 / (1 - 0.3 * 0.3);
  const std::string text =
      scene(kFloor + R"(, {"material": 1, "outer": [[0, 0, 1], [1, 0, 1], [1, 2, 1], [0, 2, 1]]},
    {"material": 3, "outer": [[0, 2.001, 1], [1, 2.001, 1], [1, 3.001, 1], [0, 3.001, 1]]})",
            kFloorHeld + R"(, "measured_points": [[0.5, 2, 2]])",
            R"({"density": 20, "unit_weight": 0, "youngs_modulus": 1e9, "poissons_ratio": 0.3,
      "strength": {"surface": "tresca", "cohesion": 1e6}}, )" +
                kStiff + R"(, {"density": 20000, "unit_weight": 196200, "youngs_modulus": 5e10, "poissons_ratio": 0.25,
      "initial_velocity": [0, -3.1320919526731650, 0]})",
            0, 2.5e-4, 240, R"({"side": 0.35, "materials": [[1]]})");
  const Done done = run_of("pillar", text);
  EXPECT_EQ(done.exit_code, 0) << done.messages;
  double sink = 0;
  for (int i = 0; i < 50; ++i) {
    const double work = kMass * kGravity * (kFall + sink) + kStrength * kStrength * kLength / (2 * modulus);
    sink = kLength * (1 - std::exp(-work / (kStrength * kLength)));
  }
  const auto history = formats::read_csv(formats::load(done.folder + "/out/history.csv"));
  const std::size_t column = formats::csv_column(history, "dy1 [L]");
  double lowest = 0;
  for (const auto& row : history.rows) lowest = std::min(lowest, std::stod(row.cells[column]));
  EXPECT_NEAR(-lowest, sink, 0.02 * sink);
}

// A square that comes down on a slope, rotating, slides on and is caught by a bolt.
TEST(YieldingMotion, a_body_that_slides_turns_and_hangs_on_a_bolt_closes_its_books) {
  const std::string text = scene(
      R"({"material": 2, "outer": [[-6, -4, 1], [6, -4, 1], [6, 3, 1]]},
    {"material": 1, "outer": [[1.9748, 0.7099, 1], [2.8386, 1.2137, 1], [2.3347, 2.0775, 1], [1.4709, 1.5736, 1]]})",
      R"("fixed_points": [[5, -3.5, 1], [5.9, 2, 1]], "bolts": [[2.155, 1.394, 5.5, 2.6, 2, 1, 1e5, 1e9, 0]])",
      R"({"density": 2600, "unit_weight": 25506, "youngs_modulus": 1e8, "poissons_ratio": 0.25,
      "initial_velocity": [0, -1, 0.8], "strength": {"cohesion": 2.5e4, "friction_deg": 20, "dilation_deg": 0}}, )" +
          kStiff,
      10, 1e-3, 1200, R"({"side": 0.4, "materials": [[1]]})");
  const Done done = run_of("bolt", text);
  EXPECT_EQ(done.exit_code, 0) << done.messages;
  EXPECT_LT(done.closure(), 1e-8);
  EXPECT_GT(done.column("plastic").back(), 0.01 * done.report["ledger"]["largest_energy"].get<double>());
  EXPECT_GT(done.column("friction").back(), 0);
  EXPECT_GT(std::ranges::max(done.column("contact")), 0);
}

}  // namespace keyblock::yielding_motion_test
