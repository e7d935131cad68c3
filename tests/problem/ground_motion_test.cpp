// A motion of the ground becomes an acceleration of the blocks: force = motion × weight (legacy-formats 2.8).
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/ground_motion.hpp"

#include <gtest/gtest.h>

#include "problem/checks/check.hpp"

namespace keyblock::ground_motion_test {
namespace {

Analysis analysis_with(std::vector<std::pair<double, double>> densities_and_weights) {
  Analysis analysis;
  for (const auto& [density, weight] : densities_and_weights) {
    analysis.block_materials.emplace_back().density = density;
    analysis.block_materials.back().unit_weight = weight;
  }
  return analysis;
}

const TimeCurve kMotion{{0, 0.5}, {{0.25, 0}, {-0.5, 0}}, {"quake", 0, 0}};

std::vector<std::string> names(const Warnings& warnings) {
  std::vector<std::string> all;
  for (const Warning& warning : warnings) all.push_back(warning.name);
  return all;
}

}  // namespace

TEST(GroundMotion, is_a_multiple_of_weight_over_mass) {
  Analysis analysis = analysis_with({{2, 20}, {2.5, 25}});
  EXPECT_EQ(names(apply_motion(analysis, kMotion)), std::vector<std::string>{"motion_applied"});
  EXPECT_EQ(analysis.body_acceleration.times, kMotion.times);
  EXPECT_EQ(analysis.body_acceleration.values, (std::vector<Point>{{2.5, 0}, {-5, 0}}));
}

TEST(GroundMotion, of_materials_without_one_gravity_takes_the_first_and_says_so) {
  Analysis analysis = analysis_with({{2, 20}, {2, 0}});
  EXPECT_EQ(names(apply_motion(analysis, kMotion)),
            (std::vector<std::string>{"motion_applied", "motion_of_one_gravity"}));
  EXPECT_EQ(analysis.body_acceleration.values.at(0), (Point{2.5, 0}));
}

TEST(GroundMotion, is_a_multiple_of_the_gravity_that_the_analysis_states) {
  Analysis analysis = analysis_with({{2, 20}, {2, 0}});
  analysis.gravity = 8;
  EXPECT_EQ(names(apply_motion(analysis, kMotion)), std::vector<std::string>{"motion_applied"});
  EXPECT_EQ(analysis.body_acceleration.values.at(0), (Point{2, 0}));
}

TEST(GroundMotion, without_gravity_or_beside_another_acceleration_is_refused) {
  Analysis analysis = analysis_with({{2, 0}});
  EXPECT_THROW(apply_motion(analysis, kMotion), InputError);
  analysis.gravity = 8;
  apply_motion(analysis, kMotion);
  EXPECT_THROW(apply_motion(analysis, kMotion), InputError);
}

TEST(GroundMotion, a_checked_problem_has_it_in_its_analysis_once) {
  Problem problem;
  problem.analysis = analysis_with({{2, 20}});
  problem.motion = kMotion;
  const Checked checked = check(problem);
  EXPECT_FALSE(checked.problem.motion);
  EXPECT_EQ(checked.problem.analysis->body_acceleration.values.at(1), (Point{-5, 0}));
  EXPECT_EQ(names(checked.warnings), std::vector<std::string>{"motion_applied"});
  problem.analysis->block_materials[0].unit_weight = 0;
  EXPECT_EQ(check(problem).errors.size(), 1U);
}

}  // namespace keyblock::ground_motion_test
