// Statics of soft NMM bodies in contact: an equilibrium that is not found at once is found by load increments.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::soft_statics_test {
namespace {

// A block on a block on a beam on two fixed points: all on covers, so soft that the beam sags by a third of its height.
constexpr const char* kPile = R"({"keyblock": 1,
 "blocks": {"blocks": [{"material": 1, "outer": [[0, 0, 1], [10, 0, 1], [10, 2, 1], [0, 2, 1]]},
                       {"material": 2, "outer": [[3, 2, 1], [6, 2, 1], [6, 4, 1], [3, 4, 1]]},
                       {"material": 3, "outer": [[4, 4, 1], [5, 4, 1], [5, 5, 1], [4, 5, 1]]}],
            "fixed_points": [[0.5, 0.5, 1], [9.5, 0.5, 1]], "measured_points": [[4.5, 5, 3]]},
 "covers": {"functions": "derived", "mesh": {"side": 0.6, "materials": [[1], [2], [3]]}},
 "analysis": {"velocity_carry_over": 0, "step_count": 1, "time_step": 0.01, "allowed_displacement_ratio": 0.05,
              "gravity": 9.81, "penalty_factor": 10, "joint_materials": [{"friction_angle_deg": 30}],
              "block_materials": [
 {"density": 2000, "unit_weight": 19620, "youngs_modulus": 1e7, "poissons_ratio": 0.2},
 {"density": 2000, "unit_weight": 19620, "youngs_modulus": 1e7, "poissons_ratio": 0.2},
 {"density": 2000, "unit_weight": 19620, "youngs_modulus": 1e7, "poissons_ratio": 0.2}]}}
)";

double sag(const std::string& folder) {
  const std::string table = support::read_text(folder + "/points.csv");
  const std::string last = table.substr(table.rfind('\n', table.size() - 2) + 1);
  std::size_t at = 0;
  for (int comma = 0; comma < 6; ++comma) at = last.find(',', at) + 1;  // step, time, point, x, y, dx, dy
  return std::stod(last.substr(at));
}

}  // namespace

TEST(SoftStatics, an_equilibrium_lost_at_once_is_found_in_parts_of_the_load) {
  const std::filesystem::path folder = support::fresh_folder("soft_statics");
  const std::string file = (folder / "pile.json").string();
  support::write_text(file, kPile);
  const std::string at_once = (folder / "at_once").string();
  const std::string in_parts = (folder / "in_parts").string();
  const auto run = support::run_keyblock({"run", file, "-o", at_once});
  EXPECT_EQ(run.exit_code, 1) << "the pile settles by more than a tenth of a body: " << run.messages;
  EXPECT_TRUE(run.messages.find("[equilibrium_far_away]") != std::string::npos) << run.messages;
  EXPECT_EQ(support::run_keyblock({"run", file, "--set", "load_steps=5", "-o", in_parts}).exit_code, 1);
  EXPECT_LT(sag(at_once), -0.5);
  EXPECT_NEAR(sag(at_once) / sag(in_parts), 1, 1e-9);
}

// A beam on two fixed points at mid-height: it hangs between them, symmetric, with or without anything else in the
// scene.
TEST(SoftStatics, fixed_points_hold_a_body_on_covers_that_touches_nothing) {
  const std::filesystem::path folder = support::fresh_folder("held_beam");
  const std::string file = (folder / "beam.json").string();
  support::write_text(file, R"({"keyblock": 1,
 "blocks": {"blocks": [{"material": 1, "outer": [[0, 0, 1], [10, 0, 1], [10, 2, 1], [0, 2, 1]]}],
            "fixed_points": [[0.5, 1, 1], [9.5, 1, 1]], "measured_points": [[5, 1, 1]]},
 "covers": {"functions": "derived", "mesh": {"side": 0.6}},
 "analysis": {"velocity_carry_over": 0, "step_count": 1, "time_step": 0.01, "allowed_displacement_ratio": 0.05,
              "gravity": 9.81, "joint_materials": [{}],
              "block_materials": [
 {"density": 2000, "unit_weight": 19620, "youngs_modulus": 1e9, "poissons_ratio": 0.2}]}}
)");
  const auto run = support::run_keyblock({"run", file, "-o", (folder / "out").string()});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  EXPECT_EQ(run.messages.find("without_effect"), std::string::npos) << run.messages;
  // Euler and Timoshenko for a beam on two supports, 5 q L⁴/384 E I + q L²/8 κ G A: 5.6 mm. The overhanging ends lift
  // the middle (q c² L²/16 E I, 0.07 mm) and each point gives way by some of its load over E.
  const double q = 19620 * 2;
  const double bending = 5 * q * std::pow(9, 4) / (384 * 1e9 * 8 / 12.0);
  const double shear = q * 81 / 8 / (5 / 6.0 * 1e9 / 2.4 * 2);
  EXPECT_NEAR(sag((folder / "out").string()) / -(bending + shear), 1, 0.1);
}

}  // namespace keyblock::soft_statics_test
