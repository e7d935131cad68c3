// Twelve pairs of Shi's manifold program, if available: the equilibrium of their fixed bodies by linear elasticity, and
// the progress of the runs of the files. The reference is a prototype with its own assembly.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/sample_covers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problem/checks/check.hpp"
#include "run/prepare.hpp"
#include "tests/support/held_statics.hpp"

namespace keyblock::sample_covers_test {
namespace {

using support::displacement_of;
using support::held_statics;
using support::HeldStatics;

class SampleRuns : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_sample_covers()) GTEST_SKIP() << "no samples; name their folder in KEYBLOCK_SHARED";
  }

  static ShiScene scene(const std::string& number) {
    return shi_scene(prepare(check(sample_pair(number)).problem, "legacy", {}).scene);
  }

  // Fixed points by 1e4 E, as in the prototype.
  static double spring(const ShiScene& scene) { return 1e4 * scene.model.block_materials.front().youngs_modulus; }
  static HeldStatics statics(const ShiScene& scene) { return held_statics(scene, spring(scene)); }

  // All steps of the file.
  static Stepping rerun(const ShiScene& scene) {
    Stepping stepping = start(scene);
    for (int i = 0; i < scene.settings.step_count; ++i) {
      const auto made = advance(scene, stepping);
      if (const auto* failure = std::get_if<StepFailure>(&made)) {
        ADD_FAILURE() << failure->reason;
        break;
      }
    }
    return stepping;
  }
};

}  // namespace

TEST_F(SampleRuns, held_bodies_come_to_the_displacements_of_the_prototype) {
  EXPECT_NEAR(statics(scene("01")).greatest_displacement, 0.11, 0.005);
  EXPECT_NEAR(statics(scene("06")).greatest_displacement, 1.5e-4, 0.1e-4);
  EXPECT_NEAR(statics(scene("09")).greatest_displacement, 0.31, 0.02);
  const HeldStatics slope = statics(scene("04"));
  EXPECT_NEAR(slope.greatest_displacement, 0.05, 0.005);
  EXPECT_NEAR(slope.least_stress_yy, -0.18, 0.005);
  EXPECT_NEAR(slope.greatest_stress_yy, 0.12, 0.005);
  EXPECT_EQ(statics(scene("03")).held_bodies, 4);
}

TEST_F(SampleRuns, the_apex_of_02_and_the_spring_of_07_go_where_the_prototype_found_them) {
  const ShiScene wedge = scene("02");
  const Point apex = displacement_of(wedge, statics(wedge).increments, wedge.model.loading_points[0]);
  EXPECT_NEAR(apex.x, 0.184, 0.0005);
  EXPECT_NEAR(apex.y, 0.266, 0.0005);
  const ShiScene clock = scene("07");
  const HeldStatics spring = statics(clock);
  EXPECT_NEAR(displacement_of(clock, spring.increments, clock.model.loading_points[0]).y, -53.8, 0.05);
  EXPECT_NEAR(2 * std::numbers::pi / spring.omega, 102, 0.5);
}

TEST_F(SampleRuns, the_five_static_steps_of_02_stay_far_from_equilibrium) {
  const ShiScene wedge = scene("02");
  const HeldStatics equilibrium = statics(wedge);
  const double apex = length(displacement_of(wedge, equilibrium.increments, wedge.model.loading_points[0]));
  const double reached = length(rerun(wedge).state.loading_points[0].displacement) / apex;
  EXPECT_GT(reached, 0.05);
  EXPECT_LT(reached, 0.1);
  EXPECT_NEAR(1 - equilibrium.remaining_share(0.2, 5), 0.086, 0.006);
}

TEST_F(SampleRuns, files_run_to_their_last_step) {
  for (const char* number : {"01", "02", "04", "06", "09"}) {
    SCOPED_TRACE(number);
    const ShiScene pair = scene(number);
    const Stepping end = rerun(pair);
    EXPECT_EQ(end.state.step, pair.settings.step_count);
    EXPECT_FALSE(impossible(end.state));
  }
}

}  // namespace keyblock::sample_covers_test
