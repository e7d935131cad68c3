// The start of blocks on springs: forces that fit the gaps, so that nothing rings, creeps or is kicked.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/compatible_start.hpp"

#include <gtest/gtest.h>

#include "tests/support/standard_scenes.hpp"

namespace keyblock::compatible_start_test {
namespace {

using support::plain_analysis;
using support::radians;
using support::standard_scene_of;
using support::standard_settings;
using support::turned_rectangle;

constexpr double kWidth = 1;
constexpr double kStep = 1e-3;

/// A column of b/h = 0.9 tan a on a slope a of 10 degrees.
double height() {
  return kWidth / (0.9 * std::tan(radians(10)));
}

Blocks column_on_slope() {
  const double slope = radians(10);
  Blocks scene;
  scene.blocks = {turned_rectangle({0, -2}, {20, 0}, -slope), turned_rectangle({6, 0}, {6 + kWidth, height()}, -slope)};
  scene.fixed_points = {{turned(Point{1, -1}, -slope), 0, {}}, {turned(Point{19, -1}, -slope), 0, {}}};
  return scene;
}

/// Angular acceleration of the rigid column about its toe: (b² + h²)/3 θ'' = g/2 √(b² + h²) sin θ, θ from the vertical to the
/// line from toe to centroid.
double first_acceleration() {
  const double theta = radians(10) - std::atan(kWidth / height());
  return 1.5 * 9.81 * std::sin(theta) / std::hypot(kWidth, height());
}

}  // namespace

// A heel pressed into its spring by the shift of the toe would throw the column over at 7e-4 rad/s, 30 times as fast as it is
// after these steps.
TEST(CompatibleStart, the_heel_of_a_toppling_column_on_springs_gives_it_no_spin) {
  for (const BlockBasis basis : {BlockBasis::rigid, BlockBasis::affine}) {
    Analysis analysis = plain_analysis(kStep, 100);
    analysis.penalty_factor = 10;
    analysis.joint_materials[0].friction_angle_deg = 50;
    Settings settings = standard_settings(analysis);
    settings.basis = basis;
    settings.standard.enforcement = Enforcement::penalty;
    StandardStepper stepper(standard_scene_of(column_on_slope(), analysis, settings));
    constexpr double kTime = 20 * kStep;
    support::run_to(stepper, kTime);
    const double spin = stepper.state().elements[ElementIndex{1}].velocity[2];
    const double expected = -first_acceleration() * kTime;
    EXPECT_NEAR(spin, expected, 0.05 * std::abs(expected)) << "basis " << static_cast<int>(basis);
  }
}

// Three points an edge leave one of the normal forces open to a rigid block. A share of ringing makes it slip by
// μ g/ω for ever where friction just holds.
TEST(CompatibleStart, a_block_on_springs_stays_where_friction_just_holds_it) {
  for (const BlockBasis basis : {BlockBasis::rigid, BlockBasis::affine}) {
    for (const double penalty_factor : {1, 10, 100}) {
      Analysis analysis = plain_analysis(1e-2, 100);
      analysis.penalty_factor = penalty_factor;
      analysis.joint_materials[0].friction_angle_deg = 30;
      Settings settings = standard_settings(analysis);
      settings.basis = basis;
      settings.standard.enforcement = Enforcement::penalty;
      StandardStepper stepper(standard_scene_of(support::block_on_slope(radians(30)), analysis, settings));
      const State start = stepper.state();
      support::run_to(stepper, 1);
      EXPECT_LT(length(support::travel(stepper, start, 1)), 1e-8) << "springs of " << penalty_factor << " E";
    }
  }
}

TEST(CompatibleStart, the_start_is_reported) {
  Analysis analysis = plain_analysis(kStep, 1);
  analysis.joint_materials[0].friction_angle_deg = 50;
  Settings settings = standard_settings(analysis);
  const StandardStepper asked(standard_scene_of(column_on_slope(), analysis, settings));
  EXPECT_EQ(asked.start_report().made, "compatible");
  EXPECT_EQ(asked.start_report().why, "");
  EXPECT_LE(asked.start_report().misfit, 1e-6);
  settings.standard.start = StartRule::sudden;
  EXPECT_EQ(StandardStepper(standard_scene_of(column_on_slope(), analysis, settings)).start_report().made,
            "as the file has it");
}

}  // namespace keyblock::compatible_start_test
