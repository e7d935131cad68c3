// The warning of locking functions for a footing, compared with the load of Prandtl (1920).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "formats/text/csv.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::locking_footing_test {
namespace {

/// Half of a smooth footing of half width 1 on weightless rock of cohesion 10, pressed down by 3 % of that: 1,006
/// unknowns.
std::string footing(const std::string& more) {
  return R"({"keyblock": 1, "blocks": {"blocks": [{"outer":
    [[0, -3, 1], [5, -3, 1], [5, 0, 1], [1, 0, 1], [0, 0, 1]]}], "measured_points": [[0, 0, 1]]},
    "covers": {"contact": "ignored", "mesh": {"side": 0.2, "through_x": 1, "through_y": 0, "angle": 0},
    "displacements": [{"along": [[0, -3], [5, -3]]}, {"along": [[5, -3], [5, 0]], "held": "x"},
      {"along": [[0, 0], [0, -3]], "held": "x"}, {"along": [[1, 0], [0, 0]], "held": "y", "y": -0.03}])" +
         more + R"(}, "analysis": {"step_count": 20, "time_step": 1, "velocity_carry_over": 0, "gravity": 0,
    "plane_strain": true, "allowed_displacement_ratio": 0.1, "joint_materials": [{}], "block_materials": [
    {"density": 1, "unit_weight": 0, "youngs_modulus": 1e4, "poissons_ratio": 0.45,
     "strength": {"surface": "tresca", "cohesion": 10}}]}})";
}

struct Borne {
  double load = 0;
  std::string messages;
};

Borne borne_by(const std::string& name, const std::string& more) {
  const std::string folder = support::fresh_folder("locking_footing_" + name);
  support::write_text(folder + "/in.json", footing(more));
  const support::ProgramRun run = support::run_keyblock({"run", folder + "/in.json", "-o", folder + "/out"});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  const std::string file = folder + "/out/history.csv";
  const formats::CsvTable table = formats::read_csv({file, support::read_text(file)});
  return {std::abs(formats::csv_real(table, table.rows.back(), formats::csv_column(table, "reaction4_y [F]"))),
          run.messages};
}

}  // namespace

TEST(LockingFooting, derived_functions_bear_as_much_too_much_as_their_warning_says) {
  const double exact = (2 + std::numbers::pi) * 10;
  const Borne derived = borne_by("derived", R"(, "functions": "derived")");
  EXPECT_NEAR(derived.load / exact, 1.64, 0.02);
  EXPECT_NE(derived.messages.find("by 64 % with 1,006 unknowns"), std::string::npos) << derived.messages;
  const Borne constant = borne_by("constant", "");
  EXPECT_NEAR(constant.load / exact, 1.014, 0.005);
  EXPECT_EQ(constant.messages.find("functions_lock"), std::string::npos) << constant.messages;
}

}  // namespace keyblock::locking_footing_test
