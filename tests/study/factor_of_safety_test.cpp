// The search for a factor of safety: the factors it tries, its verdict "stable", and its message without a verdict.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/strength/factor_of_safety.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/context.hpp"
#include "formats/case.hpp"
#include "run/cover_settings.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::study::factor_of_safety_test {
namespace {

const std::string kCases = KEYBLOCK_SOURCE_DIR "/legacy_cases/";

double tangent(double degrees) {
  return std::tan(degrees * std::numbers::pi / 180);
}

StrengthTrials block_on_plane(const std::vector<Override>& overrides = {}) {
  const std::string name = kCases + "strength_reduction/block_on_plane/block_on_plane";
  const Problem problem = formats::load_case({name + ".blk", name + ".ana"}).problem;
  return {configured_under("standard", {}, problem, overrides), Reduced::joints};
}

StrengthTrials slope(double dilation_deg) {
  const std::string name = kCases + "strength_reduction/two_to_one/two_to_one.json";
  Problem problem = formats::load_case({name}).problem;
  Strength strength = *problem.analysis->block_materials[0].strength;
  strength.values.dilation_deg = dilation_deg;
  problem.analysis->block_materials[0].strength = std::make_shared<const Strength>(strength);
  return {configured_under("standard", {}, problem, {{"mesh.side", "2"}}), Reduced::rock};
}

/// A block of 1 m on a plane of 30 degrees (gravity is turned), with a fixed stop at some distance below it.
StrengthTrials block_above_a_stop(double distance, double friction_deg) {
  Blocks all;
  all.blocks = {support::rectangle({-2, -1}, {6, 0}), support::rectangle({0, 0}, {1, 1}),
                support::rectangle({1 + distance, 0}, {2 + distance, 2})};
  all.fixed_points = {
      {{-1, -0.5}, 0, {}}, {{5, -0.5}, 0, {}}, {{1.2 + distance, 1}, 2, {}}, {{1.8 + distance, 1}, 2, {}}};
  Problem problem;
  problem.geometry = all;
  problem.analysis = support::plain_analysis(1e-3, 1);
  problem.analysis->joint_materials[0].friction_angle_deg = friction_deg;
  const double g = 10;
  return {configured_under("standard", {}, problem,
                           {{"gravity.x", std::to_string(g / 2)}, {"gravity.y", std::to_string(-g * std::sqrt(0.75))}}),
          Reduced::joints};
}

}  // namespace

// At weak joints all factors down to a fifth let the block slide to its stop, and the equilibrium there seemed to be
// that of the drawing: F = 16, not 0.15.
TEST(FactorOfSafety, a_block_that_slides_to_a_stop_does_not_stand_whatever_its_friction) {
  for (const double distance : {0.2, 1.0})
    for (const double friction : {3.0, 10.0, 20.0}) {
      const FactorOfSafety found = factor_of_safety(block_above_a_stop(distance, friction), {});
      ASSERT_EQ(found.end, SearchEnd::bracketed) << distance << " " << friction;
      EXPECT_LE(*found.bracket.stands, 1.001 * tangent(friction) / tangent(30)) << distance << " " << friction;
      EXPECT_GE(*found.bracket.falls, 0.999 * tangent(friction) / tangent(30)) << distance << " " << friction;
    }
}

TEST(FactorOfSafety, goes_up_by_quarters_and_bisects) {
  const FactorOfSafety found = factor_of_safety(block_on_plane(), {});
  ASSERT_EQ(found.end, SearchEnd::bracketed);
  ASSERT_GE(found.trials.size(), 4U);
  EXPECT_EQ(found.trials[0].factor, 1);
  EXPECT_EQ(found.trials[1].factor, 1.25);
  EXPECT_EQ(found.trials[2].factor, 1.5625);
  EXPECT_EQ(found.trials[3].factor, (1.25 + 1.5625) / 2);
  EXPECT_LE(found.bracket.width(), 0.01);
  EXPECT_LE(*found.bracket.stands, tangent(40) / tangent(30));
  EXPECT_GE(*found.bracket.falls, tangent(40) / tangent(30));
  EXPECT_TRUE(found.is_safe());
}

TEST(FactorOfSafety, keeps_to_the_bracket_that_was_asked_for) {
  const FactorOfSafety found = factor_of_safety(block_on_plane(), {1.2, 1.6, 0.1});
  ASSERT_EQ(found.end, SearchEnd::bracketed);
  EXPECT_EQ(found.trials[0].factor, 1.2);
  EXPECT_EQ(found.trials[1].factor, 1.6);
  EXPECT_EQ(factor_of_safety(block_on_plane(), {1.5, 1.6, 0.1}).end, SearchEnd::falls);
  EXPECT_EQ(factor_of_safety(block_on_plane(), {1.2, 1.3, 0.1}).end, SearchEnd::stands);
}

TEST(FactorOfSafety, what_falls_shows_the_block_that_moves) {
  const FactorOfSafety found = factor_of_safety(block_on_plane(), {});
  ASSERT_TRUE(found.standing && found.falling);
  const auto moved = [&](std::size_t e) {
    return length(found.falling->elements[e].middle.displacement -
                  found.standing->field.elements[e].middle.displacement);
  };
  ASSERT_EQ(found.falling->elements.size(), 2U);
  EXPECT_GT(moved(0), 0.5);  // of 1 m
  EXPECT_EQ(moved(1), 0);
}

// Above 1 the block falls as well with rigid blocks, which have no displacement while they are stable.
TEST(FactorOfSafety, rigid_blocks_have_no_knee) {
  const FactorOfSafety found = factor_of_safety(block_on_plane({{"basis", "rigid"}}), {});
  ASSERT_EQ(found.end, SearchEnd::bracketed);
  EXPECT_NEAR(found.bracket.middle(), tangent(40) / tangent(30), 0.01);
  for (const StrengthTrial& trial : found.trials) EXPECT_FALSE(trial.is_past_knee) << trial.factor;
}

TEST(FactorOfSafety, a_stop_keeps_the_trials_made) {
  SearchOptions options;
  const Context own;
  int made = 0;
  options.on_trial = [&](const StrengthTrial&) {
    if (++made == 2) own.stop();
  };
  const Under under(own);
  const FactorOfSafety found = factor_of_safety(block_on_plane(), options);
  EXPECT_EQ(found.end, SearchEnd::stopped);
  EXPECT_EQ(found.trials.size(), 2U);
  EXPECT_FALSE(found.is_safe());
}

// A coarse mesh, whose slope slides far before equilibrium fails (tests/run/yielding_rock_test.cpp).
TEST(FactorOfSafety, rock_is_judged_by_equilibrium_and_its_knee_is_told) {
  const FactorOfSafety found = factor_of_safety(slope(20), {});
  ASSERT_EQ(found.end, SearchEnd::bracketed);
  for (const StrengthTrial& trial : found.trials) EXPECT_EQ(trial.verdict == Verdict::stands, trial.is_balanced);
  bool is_said = false;
  for (const std::string& note : found.notes) is_said |= note.find("serviceability") != std::string::npos;
  EXPECT_EQ(is_said, found.grows_before_it_falls());
  EXPECT_FALSE(found.is_lower_estimate);
  EXPECT_TRUE(found.standing->plastic_strains.size() == found.standing->field.elements.size());
  double most = 0;
  for (const double strain : found.standing->plastic_strains) most = std::max(most, strain);
  EXPECT_GT(most, 0);
}

// More than trials with convergent contact forces take, or than trials seen to take longer; 0 is unlimited.
TEST(FactorOfSafety, a_trial_has_a_limit_unless_none_is_asked_for) {
  EXPECT_EQ(trial_limit(std::nullopt, 0), 100000);
  EXPECT_EQ(trial_limit(std::nullopt, 50000), 500000);
  EXPECT_EQ(trial_limit(7, 5000), 7);
  EXPECT_EQ(trial_limit(0, 5000), std::nullopt);
}

// The verdict is that of the count alone.
TEST(FactorOfSafety, a_trial_is_given_up_after_its_linear_systems) {
  const StrengthTrials trials = block_on_plane();
  const long long systems = trials.run(1.2).told.systems;
  ASSERT_GT(systems, 1);
  EXPECT_EQ(trials.run(1.2, systems).told.verdict, Verdict::stands);
  const StrengthTrial given_up = trials.run(1.2, systems - 1).told;
  EXPECT_EQ(given_up.verdict, Verdict::undecided);
  EXPECT_EQ(given_up.systems, systems - 1);
}

}  // namespace keyblock::study::factor_of_safety_test
