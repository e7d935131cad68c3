// Impacts that springs stop: the rebound that strain damping leaves, and steps too long for the springs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/ahead/spring_impacts.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "formats/case.hpp"
#include "run/prepare.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::spring_impacts_test {
namespace {

/// A square of 1 m and 1000 kg over a fixed floor; one spring has 10 E.
Warnings told(const std::vector<Override>& settings, double time_step) {
  const std::string file = support::fresh_folder("spring_impacts") + "/in.json";
  support::write_text(file, R"({"keyblock": 1, "blocks": {"blocks": [
    {"outer": [[-2, -1, 1], [2, -1, 1], [2, 0, 1], [-2, 0, 1]]},
    {"outer": [[0, 0.5, 1], [1, 0.5, 1], [1, 1.5, 1], [0, 1.5, 1]]}],
    "fixed_points": [[-1.9, -0.5, 1], [1.9, -0.5, 1]]}, "analysis": {"velocity_carry_over": 1, "step_count": 10,
    "time_step": )" + std::to_string(time_step) +
                                R"(, "allowed_displacement_ratio": 0.1, "gravity": 9.81, "penalty_factor": 10,
    "block_materials": [{"density": 1000, "unit_weight": 9810, "youngs_modulus": 1e9, "poissons_ratio": 0}],
    "joint_materials": [{}]}})");
  return spring_impacts(prepare(formats::load_case({file}).problem, "standard", settings).scene, {});
}

bool has(const Warnings& warnings, const std::string& name) {
  return std::ranges::any_of(warnings, [&](const Warning& w) { return w.name == name; });
}

}  // namespace

TEST(SpringImpacts, a_stiff_undamped_block_rebounds_with_all_of_its_speed) {
  EXPECT_NEAR((SpringImpact{1000, 1e8, 1e12, 0}).rebound(), 1, 1e-2);
}

// A heavily damped corner is a rigid one: all of the speed again. In between, the damper takes more the nearer its rate
// is to that of the impact.
TEST(SpringImpacts, damping_takes_the_most_where_it_is_critical) {
  const double omega = std::sqrt(1e10 / (1000.0 / 3));
  const double critical = (SpringImpact{1000, 1e12, 1e10, 2 / omega}).rebound();
  EXPECT_LT(critical, 0.3);
  EXPECT_GT((SpringImpact{1000, 1e12, 1e10, 0.02 / omega}).rebound(), 0.8);
}

// omega = sqrt(2e10 / 1000) = 4472 1/s.
TEST(SpringImpacts, a_step_beyond_one_over_omega_is_told_with_the_step_that_resolves_it) {
  const Warnings found = told({{"impact", "springs"}, {"strain_damping", "none"}}, 0.002);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name, "springs_unresolved");
  EXPECT_TRUE(support::contains(found[0].sentence, "omega dt is 8.94, beyond 1")) << found[0].sentence;
  EXPECT_TRUE(support::contains(found[0].sentence, "time_step=3.5e-05")) << found[0].sentence;
  EXPECT_TRUE(told({{"impact", "springs"}, {"strain_damping", "none"}}, 0.0001).empty());
}

TEST(SpringImpacts, strain_damping_is_told_where_springs_stop_impacts_and_only_there) {
  EXPECT_TRUE(has(told({{"impact", "springs"}}, 0.00003), "strain_damping_takes_rebound"));
  EXPECT_TRUE(told({}, 0.002).empty()) << "a jump of velocities";
  EXPECT_TRUE(told({{"impact", "springs"}, {"basis", "rigid"}}, 0.0001).empty()) << "no strain";
}

}  // namespace keyblock::spring_impacts_test
