// A soft bar on covers, pressed between two stiff plates without friction to a fraction of its length. Under plane
// strain with free sides its Cauchy stress is E* ln λ / (λ μ) by the logarithmic law, μ = λ^(-ν/(1-ν)), E* = E/(1-ν²).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::pressed_bar_test {
namespace {

/// The upper plate comes down within a second, and stays for half of one.
std::string pressed_to(double stretch) {
  const std::string down = fmt::format("[[0, 0, 0], [1, 0, {0}], [2, 0, {0}]]", stretch - 1);
  return R"({"keyblock": 1, "blocks": {"blocks": [
    {"material": 1, "outer": [[-3, -1, 1], [3, -1, 1], [3, 0, 1], [-3, 0, 1]]},
    {"material": 2, "outer": [[-0.5, 0, 1], [0.5, 0, 1], [0.5, 1, 1], [-0.5, 1, 1]]},
    {"material": 1, "outer": [[-3, 1, 1], [3, 1, 1], [3, 2, 1], [-3, 2, 1]]}],
    "measured_points": [[0, 0.5, 2]], "fixed_points": [[-2, -0.5, 1], [2, -0.5, 1], [-2, 1.5, 3], [2, 1.5, 3]]},
    "analysis": {"velocity_carry_over": 1, "step_count": 375, "time_step": 0.004, "allowed_displacement_ratio": 1,
    "gravity": 0, "plane_strain": true, "fixed_point_motions": [[[0, 0, 0]], [[0, 0, 0]], )" +
         down + ", " + down + R"(], "block_materials": [
    {"density": 1, "unit_weight": 0, "youngs_modulus": 1e8, "poissons_ratio": 0.3},
    {"density": 0.1, "unit_weight": 0, "youngs_modulus": 1000, "poissons_ratio": 0.3}],
    "joint_materials": [{"friction_angle_deg": 0, "cohesion": 0, "tensile_strength": 0}], "penalty_factor": 10},
    "covers": {"functions": "derived", "mesh": {"side": 0.25, "materials": [[2]]}},
    "run": {"set": {"mass_damping.2": "30", "basis": "rigid", "crushing_limit": "0"}}})";
}

struct Pressed {
  int exit_code = 0;
  std::string messages;
  double syy = 0;  ///< at the middle of the bar, at the end
};

Pressed pressed(double stretch, const std::string& law) {
  const std::string folder = support::fresh_folder("pressed");
  support::write_text(folder + "/in.json", pressed_to(stretch));
  const auto run =
      support::run_keyblock({"run", folder + "/in.json", "-o", folder + "/out", "--set", "elastic_law=" + law});
  const std::string points = support::read_text(folder + "/out/points.csv");
  std::istringstream row(points.substr(points.rfind('\n', points.size() - 2) + 1));
  std::vector<double> cells;
  for (std::string cell; std::getline(row, cell, ',');) cells.push_back(std::stod(cell));
  return {run.exit_code, run.messages, cells.at(8)};
}

}  // namespace

// To 0.6 of its length, beyond the limit of the other law; 2 % for a mesh of four sides per face.
TEST(PressedBar, the_logarithmic_law_follows_its_closed_form_beyond_where_the_other_gives_way) {
  constexpr double kStretch = 0.6;
  const Pressed log = pressed(kStretch, "logarithmic");
  EXPECT_EQ(log.exit_code, 0) << log.messages;
  const double width = std::pow(kStretch, -0.3 / 0.7);
  const double theory = 1000 / 0.91 * std::log(kStretch) / (kStretch * width);
  EXPECT_NEAR(log.syy, theory, 0.02 * std::abs(theory));
  const Pressed other = pressed(kStretch, "st_venant_kirchhoff");
  EXPECT_EQ(other.exit_code, 4) << other.messages;
}

}  // namespace keyblock::pressed_bar_test
