// Statics whose equilibrium lies far from the drawing: ten columns on a base at 28 degrees. They are stable at friction
// above 33.983 degrees by a limit analysis of rigid blocks (linear programme, no tension, Coulomb).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::far_equilibrium_test {
namespace {

constexpr double kLimit = 33.983;

/// Drawing and measurement of the columns.
struct Drawn {
  double unit = 1;  ///< units of length in a metre
  double shift = 0;
  double turn = 0;  ///< degrees
};

std::string columns(double friction, const Drawn& drawn) {
  const double turn = drawn.turn * std::numbers::pi / 180, slope = 28 * std::numbers::pi / 180;
  const auto at = [&](double x, double y) {
    return fmt::format("{:.17g}, {:.17g}", drawn.unit * (x * std::cos(turn) - y * std::sin(turn) + drawn.shift),
                       drawn.unit * (x * std::sin(turn) + y * std::cos(turn) + drawn.shift));
  };
  const auto box = [&](double x0, double y0, double x1, double y1) {
    return fmt::format(R"({{"outer": [[{}, 1], [{}, 1], [{}, 1], [{}, 1]]}})", at(x0, y0), at(x1, y0), at(x1, y1),
                       at(x0, y1));
  };
  std::string blocks = box(-5, -1, 15, 0);
  double x = 0;
  for (const double height : {1.2, 2.0, 2.8, 3.6, 4.4, 5.0, 4.2, 3.2, 2.2, 1.2})
    blocks += ", " + box(x, 0, x + 1, height), ++x;
  const double g = 9.81 * drawn.unit;
  // Mass in tonnes where length is in millimetres: stress is N/m² or N/mm².
  const double density = drawn.unit == 1 ? 2600 : 2.6e-9, modulus = drawn.unit == 1 ? 1e10 : 1e4;
  return fmt::format(R"({{"keyblock": 1, "blocks": {{"blocks": [{}], "fixed_points": [[{}, 1], [{}, 1]]}},
    "analysis": {{"velocity_carry_over": 1, "step_count": 1, "time_step": 0.001, "allowed_displacement_ratio": 1,
    "plane_strain": false, "block_materials": [{{"density": {:.17g}, "unit_weight": {:.17g}, "youngs_modulus": {:.17g},
    "poissons_ratio": 0.25}}], "joint_materials": [{{"friction_angle_deg": {:.17g}}}], "penalty_factor": 10}},
    "run": {{"set": {{"gravity.x": {:.17g}, "gravity.y": {:.17g}, "motion": "static"}}}}}})",
                     blocks, at(-4, -0.5), at(14, -0.5), density, density * g, modulus, friction,
                     g * std::sin(turn - slope), -g * std::cos(turn - slope));
}

struct Answer {
  int exit_code = 0;
  std::string messages;
  nlohmann::json record;

  bool says(const std::string& code) const { return messages.find("[" + code + "]") != std::string::npos; }
};

Answer answer_of(double above_limit, const Drawn& drawn = {}, const std::vector<std::string>& settings = {}) {
  const std::string folder = support::fresh_folder("far_equilibrium");
  support::write_text(folder + "/in.json", columns(kLimit + above_limit, drawn));
  std::vector<std::string> arguments{"run", folder + "/in.json", "-o", folder + "/out"};
  for (const std::string& setting : settings) arguments.insert(arguments.end(), {"--set", setting});
  const support::ProgramRun run = support::run_keyblock(arguments);
  return {run.exit_code, run.messages, nlohmann::json::parse(support::read_text(folder + "/out/run.json"))};
}

}  // namespace

TEST(FarEquilibrium, columns_below_their_limit_are_never_in_equilibrium_without_a_doubt) {
  for (const double below : {-3.0, -1.0, -0.3, -0.1}) {
    const Answer answer = answer_of(below);
    EXPECT_NE(answer.exit_code, 0) << below << ": " << answer.messages;
  }
  EXPECT_TRUE(answer_of(-1).says("equilibrium_far_away"));
}

TEST(FarEquilibrium, columns_more_than_a_degree_above_their_limit_are_not_doubted) {
  for (const double above : {1.1, 3.0}) {
    const Answer answer = answer_of(above);
    EXPECT_EQ(answer.exit_code, 0) << above << ": " << answer.messages;
    EXPECT_EQ(answer.record["outcome"]["motion"]["state"], "equilibrium");
  }
}

TEST(FarEquilibrium, columns_within_a_degree_above_their_limit_are_told_that_they_moved) {
  for (const double above : {0.1, 0.3, 0.7}) {
    const Answer answer = answer_of(above);
    EXPECT_TRUE(answer.says("equilibrium_moved") || answer.exit_code != 0) << above << ": " << answer.messages;
  }
}

// In 2 s of motion they come to rest after 2 cm, 2 % of their width, and far above the limit where they were drawn.
TEST(FarEquilibrium, columns_that_come_to_rest_elsewhere_are_told_that_they_moved) {
  const std::vector<std::string> motion{"motion=dynamic", "steps=1000", "time_step=0.002"};
  const Answer near = answer_of(1, {}, motion);
  EXPECT_EQ(near.exit_code, 0) << near.messages;
  EXPECT_EQ(near.record["outcome"]["motion"]["state"], "at_rest");
  EXPECT_TRUE(near.says("equilibrium_moved")) << near.messages;
  EXPECT_FALSE(answer_of(15, {}, motion).says("equilibrium_moved"));
}

TEST(FarEquilibrium, columns_in_other_units_places_and_axes_are_doubted_too) {
  for (const Drawn& drawn : {Drawn{1000}, Drawn{1, 1000}, Drawn{1, 0, 37}}) {
    EXPECT_NE(answer_of(-1, drawn).exit_code, 0) << drawn.unit << drawn.shift << drawn.turn;
    EXPECT_EQ(answer_of(3, drawn).exit_code, 0) << drawn.unit << drawn.shift << drawn.turn;
  }
}

}  // namespace keyblock::far_equilibrium_test
