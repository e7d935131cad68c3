// Linear statics warns of a body that rotates beyond its limits; steps in time give the elastica.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/point.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::rotation_doubt_test {
namespace {

struct Done {
  int exit_code = 0;
  std::string messages;
  Point tip;  ///< displacement of the measured point, if there is one

  bool tells_rotation() const { return messages.find("[rotated_beyond_linear]") != std::string::npos; }
};

Done run_of(const std::string& name, const std::string& text, const std::vector<std::string>& more = {}) {
  const std::string folder = support::fresh_folder("rotation_doubt_" + name);
  support::write_text(folder + "/in.json", text);
  std::vector<std::string> arguments = {"run", folder + "/in.json", "-o", folder + "/out"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const support::ProgramRun run = support::run_keyblock(arguments);
  Done done{run.exit_code, run.messages, {}};
  const std::string history = support::read_text(folder + "/out/history.csv");
  const std::size_t last = history.find_last_of('\n', history.size() - 2) + 1;
  std::vector<double> values;
  std::istringstream row(history.substr(last));
  for (std::string value; std::getline(row, value, ',');) values.push_back(std::atof(value.c_str()));
  if (values.size() >= 6) done.tip = {values[4], values[5]};
  return done;
}

/// A beam of 4 by 0.2, E 1e7, I 0.2³/12, clamped at its left end, under P at the other; E I = 6666.7.
std::string cantilever(double load) {
  return fmt::format(R"({{"keyblock": 1, "blocks": {{"blocks": [{{"outer": [[0, 0, 1], [4, 0, 1], [4, 0.2, 1],
    [0, 0.2, 1]]}}], "measured_points": [[4, 0.1, 1]]}},
    "covers": {{"functions": "quadratic", "mesh": {{"side": 0.2, "angle": 10}},
    "displacements": [{{"along": [[0, 0.2], [0, 0]]}}],
    "tractions": [{{"along": [[4, 0], [4, 0.2]], "y": {}}}]}},
    "analysis": {{"velocity_carry_over": 0, "step_count": 4, "time_step": 1, "allowed_displacement_ratio": 1,
    "plane_strain": false, "gravity": 0, "joint_materials": [{{}}],
    "block_materials": [{{"density": 1, "unit_weight": 0, "youngs_modulus": 1e7, "poissons_ratio": 0}}]}}}})",
                     -load / 0.2);
}

/// A plate on a pin and a soft spring, moved out of line by a force: it rotates as a whole.
std::string pinned(double force) {
  return fmt::format(R"({{"keyblock": 1, "blocks": {{"blocks": [{{"outer": [[0, 0, 1], [2, 0, 1], [2, 1, 1],
    [0, 1, 1]]}}]}}, "covers": {{"contact": "ignored", "mesh": {{"side": 0.5}},
    "springs": [[0, 0, 1, 0, 1e9], [0, 0, 0, 1, 1e9], [2, 0, 0, 1, 1000]], "forces": [[2, 1, 0, {}]]}},
    "analysis": {{"velocity_carry_over": 0, "step_count": 1, "time_step": 1, "allowed_displacement_ratio": 1,
    "gravity": 0, "joint_materials": [{{}}],
    "block_materials": [{{"density": 1, "unit_weight": 0, "youngs_modulus": 1e9, "poissons_ratio": 0.2}}]}}}})",
                     force);
}

}  // namespace

TEST(RotationDoubt, a_beam_that_bends_far_under_linear_statics_is_told) {
  const Done bent = run_of("bent", cantilever(1666.67));
  EXPECT_EQ(bent.exit_code, 0) << bent.messages;
  EXPECT_TRUE(bent.tells_rotation()) << bent.messages;
  EXPECT_NE(bent.messages.find("--set motion=dynamic --set start=sudden"), std::string::npos) << bent.messages;
  // P L²/(2 E I) at the end: 0.0996 and 0.1032.
  EXPECT_FALSE(run_of("little", cantilever(83)).tells_rotation());
  EXPECT_TRUE(run_of("more", cantilever(86)).tells_rotation());
}

// P L²/(E I) is 4: the tip of the elastica sinks by 0.670 of the length and comes back by 0.329 of it (Bisshopp &
// Drucker 1945). The slowest frequency of the beam is 40 rad per unit of time.
TEST(RotationDoubt, what_the_doubt_names_gives_the_elastica) {
  const Done swung = run_of("swung", cantilever(1666.67),
                            {"--set", "motion=dynamic", "--set", "start=sudden", "--set", "mass_damping=60", "--set",
                             "time_step=0.002", "--set", "steps=150"});
  EXPECT_EQ(swung.exit_code, 0) << swung.messages;
  EXPECT_NEAR(swung.tip.y, -0.670 * 4, 0.005 * 4) << swung.messages;
  EXPECT_NEAR(swung.tip.x, -0.329 * 4, 0.005 * 4) << swung.messages;
}

/// A bar of 4 by 1, E 1e5, clamped at its left end and pulled by `pull` per area at the other.
std::string pulled(double pull) {
  return fmt::format(R"({{"keyblock": 1, "blocks": {{"blocks": [{{"outer": [[0, 0, 1], [4, 0, 1], [4, 1, 1],
    [0, 1, 1]]}}]}}, "covers": {{"contact": "ignored", "mesh": {{"side": 0.4}},
    "tractions": [{{"along": [[4, 0], [4, 1]], "x": {}}}], "displacements": [{{"along": [[0, 1], [0, 0]]}}]}},
    "analysis": {{"velocity_carry_over": 0, "step_count": 1, "time_step": 1, "allowed_displacement_ratio": 1,
    "gravity": 0, "plane_strain": false, "joint_materials": [{{}}],
    "block_materials": [{{"density": 1, "unit_weight": 0, "youngs_modulus": 1e5, "poissons_ratio": 0}}]}}}})",
                     pull);
}

TEST(RotationDoubt, a_strain_beyond_a_tenth_is_told) {
  for (const double pull : {-9e4, -1.1e4, 1.1e4, 3e4})
    EXPECT_NE(run_of("pulled", pulled(pull)).messages.find("[strained_beyond_linear]"), std::string::npos) << pull;
  EXPECT_EQ(run_of("pulled", pulled(9e3)).messages.find("[strained_beyond_linear]"), std::string::npos);
}

TEST(RotationDoubt, a_rigid_rotation_counts_as_much) {
  const Done turned = run_of("turned", pinned(400));  // 0.2 rad
  EXPECT_TRUE(turned.tells_rotation()) << turned.messages;
  EXPECT_FALSE(run_of("little_turned", pinned(180)).tells_rotation());
}

}  // namespace keyblock::rotation_doubt_test
