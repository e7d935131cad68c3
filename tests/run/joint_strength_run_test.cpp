// The factor on joint strength reaches the steps of both profiles: a block slides as fast as the reduced friction
// permits.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "run/prepare.hpp"
#include "run/run.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::joint_strength_run_test {
namespace {

/// Way of a block down a slope of 30 degrees in half a second, friction angle 35 degrees in the file.
double way_down(const char* profile, const char* factor) {
  Analysis analysis = support::plain_analysis(1e-3, 500);
  analysis.joint_materials[0].friction_angle_deg = 35;
  analysis.allowed_displacement_ratio = 0.01;
  const Prepared prepared = prepare({support::block_on_slope(support::radians(30)), analysis}, profile,
                                    {{"joint_strength_factor", factor}, {"start", "compatible"}});
  double way = 0;
  Observer observer;
  observer.on_frame = [&](const Frame& frame) { way = length(frame.elements[1].displacement); };
  EXPECT_EQ(run(prepared.scene, 500, observer).end, RunEnd::finished);
  return way;
}

double expected_way(double factor) {
  const double slope = support::radians(30);
  return 9.81 * (std::sin(slope) - factor * std::tan(support::radians(35)) * std::cos(slope)) * 0.5 * 0.5 / 2;
}

}  // namespace

// s = g (sin α − f tan φ cos α) t²/2. The displacement counts from the unloaded block: 2.5e-6 m of settlement under its
// weight.
TEST(JointStrengthRun, standard_slides_at_the_reduced_friction_and_holds_at_the_full_one) {
  EXPECT_NEAR(way_down("standard", "0.5"), expected_way(0.5), 5e-6);
  EXPECT_LT(way_down("standard", "1"), 5e-6);
}

// The friction of Shi's step lags behind while the block settles under its sudden weight: the speed is off by at most g
// cos α f tan φ dt, as in legacy_cases/sliding_block.
TEST(JointStrengthRun, legacy_slides_at_the_reduced_friction) {
  const double lag = 9.81 * std::cos(support::radians(30)) * 0.5 * std::tan(support::radians(35)) * 1e-3 * 0.5;
  EXPECT_NEAR(way_down("legacy", "0.5"), expected_way(0.5), lag);
}

}  // namespace keyblock::joint_strength_run_test
