// Materials, settings and bolts act on NMM bodies as they do on DDA blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::settings_on_covers_test {
namespace {

using support::fresh_folder;
using support::read_text;
using support::run_keyblock;
using support::write_text;

const char* const kMaterials = R"("block_materials": [
  {"density": 2500, "unit_weight": 0, "youngs_modulus": 1e10, "poissons_ratio": 0, "initial_velocity": [0.5, 0, 0]},
  {"density": 2500, "unit_weight": 0, "youngs_modulus": 1e10, "poissons_ratio": 0, "initial_velocity": [0.5, 0, 0]}],
  "joint_materials": [{"friction_angle_deg": 0, "cohesion": 0, "tensile_strength": 0}], "penalty_factor": 10)";

/// Two NMM squares apart from each other, both moving to the right.
std::string two_squares(const std::string& analysis, const std::string& more, const std::string& bolts = "") {
  return R"({"keyblock": 1, "blocks": {"blocks": [
    {"material": 1, "outer": [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]},
    {"material": 2, "outer": [[0, 4, 1], [1, 4, 1], [1, 5, 1], [0, 5, 1]]}])" +
         bolts + R"(, "measured_points": [[0.5, 0.5, 1], [0.5, 4.5, 2]]}, "analysis": {)" + analysis +
         R"("allowed_displacement_ratio": 1, )" + kMaterials + "}" + more + "}";
}

const std::string kMoving = R"("velocity_carry_over": 1, "step_count": 200, "time_step": 0.001, "gravity": 0, )";
const std::string kCovers = R"(, "covers": {"functions": "linear", "mesh": {"side": 0.6, "angle": 10}})";

/// The last row of history.csv.
std::vector<double> last_row(const std::string& text, const std::vector<std::string>& more, std::string& messages) {
  const std::string folder = fresh_folder("on_covers");
  write_text(folder + "/in.json", text);
  std::vector<std::string> arguments{"run", folder + "/in.json", "-o", folder + "/out"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto run = run_keyblock(arguments);
  messages = run.messages;
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  std::istringstream lines(read_text(folder + "/out/history.csv"));
  std::string line;
  std::string last;
  while (std::getline(lines, line)) last = line;
  std::vector<double> row;
  std::istringstream cells(last);
  while (std::getline(cells, line, ',')) row.push_back(std::stod(line));
  return row;
}

/// Columns step, time, then x, y, dx, dy, … of each measured point.
std::vector<double> displacements(const std::string& text, const std::vector<std::string>& more, std::size_t column) {
  std::string messages;
  const std::vector<double> row = last_row(text, more, messages);
  const std::size_t width = (row.size() - 2) / 2;
  return {row.at(2 + column), row.at(2 + width + column)};
}

constexpr std::size_t kDx = 2;
constexpr std::size_t kDy = 3;

}  // namespace

// v = v0 exp(-a t): the way is v0 (1 - exp(-a t)) / a.
TEST(SettingsOnCovers, mass_damping_of_one_material_slows_its_bodies_alone) {
  const std::vector<double> dx = displacements(two_squares(kMoving, kCovers), {"--set", "mass_damping.2=5"}, kDx);
  EXPECT_NEAR(dx[0], 0.5 * 0.2, 1e-9);
  EXPECT_NEAR(dx[1], 0.5 * (1 - std::exp(-5 * 0.2)) / 5, 3e-4 * 0.1);
}

TEST(SettingsOnCovers, mass_damping_of_one_material_is_that_of_all_where_all_have_it) {
  const std::vector<double> one = displacements(two_squares(kMoving, kCovers), {"--set", "mass_damping.2=5"}, kDx);
  const std::vector<double> all = displacements(two_squares(kMoving, kCovers), {"--set", "mass_damping=5"}, kDx);
  EXPECT_NEAR(one[1], all[1], 1e-12);
  EXPECT_NEAR(all[0], all[1], 1e-12);
}

// A bolt alone: two free bodies of mass m on a bolt of stiffness k along y, pulled initially by the pretension P. They
// oscillate about the slack state: each by P/(2k) (1 - cos ωt), ω² = 2k/m.
TEST(SettingsOnCovers, a_bolt_holds_bodies_on_covers) {
  const std::string still = R"("velocity_carry_over": 1, "step_count": 400, "time_step": 0.0005, "gravity": 0, )";
  const std::string bolt = R"(, "bolts": [[0.5, 0.5, 0.5, 4.5, 1, 2, 1e6, 0, 2e3]])";
  const std::vector<double> dy =
      displacements(two_squares(still, kCovers, bolt), {"--set", "start=sudden", "--set", "basis=rigid"}, kDy);
  const double omega = std::sqrt(2 * 1e6 / 2500);
  const double way = 2e3 / (2 * 1e6) * (1 - std::cos(omega * 0.2));
  EXPECT_NEAR(dy[0], way, 0.02 * 1e-3);
  EXPECT_NEAR(dy[1], -way, 0.02 * 1e-3);
}

// A square of height h fixed on its lower side and pressed by p on its upper one, in linear statics: it settles by p
// h/E in plane stress.
std::string held_square(const std::string& settings) {
  return R"({"keyblock": 1, "blocks": {"blocks": [
    {"material": 1, "outer": [[0, 0, 1], [2, 0, 1], [2, 2, 1], [0, 2, 1]]}],
    "measured_points": [[1, 2, 1]]},
    "analysis": {"velocity_carry_over": 0, "step_count": 1, "time_step": 1, "allowed_displacement_ratio": 1,
    "plane_strain": false,
    "block_materials": [{"density": 1, "unit_weight": 0, "youngs_modulus": 1000, "poissons_ratio": 0.25}],
    "joint_materials": [{"friction_angle_deg": 0, "cohesion": 0, "tensile_strength": 0}], "penalty_factor": 1},
    "covers": {"functions": "linear", "mesh": {"side": 0.6, "angle": 10},
    "tractions": [{"along": [[2, 2], [0, 2]], "y": -3}],
    "displacements": [{"along": [[0, 0], [2, 0]], "held": "y"}, {"along": [[0, 0], [0, 2]], "held": "normal"}]})" +
         settings + "}";
}

TEST(SettingsOnCovers, settings_of_the_case_file_and_of_the_command_line_reach_linear_statics) {
  const double sinks = 3.0 * 2 / 1000;
  const double in_strain = sinks * (1 - 0.25 * 0.25);
  std::string messages;
  EXPECT_NEAR(last_row(held_square(""), {}, messages).at(5), -sinks, 1e-9);
  const std::string strain = R"(, "run": {"set": {"plane": "strain"}})";
  EXPECT_NEAR(last_row(held_square(strain), {}, messages).at(5), -in_strain, 1e-9);
  EXPECT_NEAR(last_row(held_square(""), {"--set", "plane=strain"}, messages).at(5), -in_strain, 1e-9);
}

// A weight moves the mean of the square by as much as a pressure of half of it on the upper side; twice the gravity
// moves it twice as far.
TEST(SettingsOnCovers, gravity_of_the_case_file_reaches_linear_statics) {
  std::string messages;
  const auto sinks = [&](const char* gravity) {
    const std::string set = fmt::format(R"(, "run": {{"set": {{"gravity.y": "{}"}}}})", gravity);
    return last_row(held_square(set), {}, messages).at(5) + 3.0 * 2 / 1000;
  };
  const double once = sinks("-1.5");
  EXPECT_NEAR(once, -1.5 * 4 / 2 / 1000, 0.03 * 0.003);  // except the lateral strain that the lower side hinders
  EXPECT_NEAR(sinks("-3"), 2 * once, 1e-9);
}

TEST(SettingsOnCovers, a_setting_that_linear_statics_does_not_know_is_told_of) {
  std::string messages;
  last_row(held_square(R"(, "run": {"set": {"mass_damping": "3"}})"), {}, messages);
  EXPECT_NE(messages.find("setting mass_damping has no effect here: it is not read by linear static solutions"),
            std::string::npos)
      << messages;
}

}  // namespace keyblock::settings_on_covers_test
