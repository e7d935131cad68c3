// A wedge slides down a face of a fixed block, tip first, into the reflex corner at the foot of that face.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/ledger_runs.hpp"

namespace keyblock::reflex_corner_test {
namespace {

constexpr double kTimeStep = 2e-3;
constexpr double kTime = 1.2;
constexpr double kDeepest = 1e-3;  // m: a thousandth of the way to the foot; the tip of a wrong contact sank by 40 mm

struct Wedge {
  double slope, low, high;  ///< degrees: the face over the floor, both edges of the wedge over the face
};

Point along(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {std::cos(angle), std::sin(angle)};
}

// The foot of the face is at the origin. The corner below on the right decides where the diagonal from the foot ends.
Blocks scene_of(const Wedge& wedge, double low_right) {
  const Point up = along(wedge.slope);
  Blocks scene;
  scene.blocks = {
      {0, {{{-6, -4}, 0}, {{low_right, -4}, 0}, {8 * up, 0}, {{0, 0}, 0}, {{-6, 0}, 0}}, {}},
      {0, {{up, 0}, {up + 3 * along(wedge.slope + wedge.low), 0}, {up + 3 * along(wedge.slope + wedge.high), 0}}, {}}};
  scene.fixed_points = {{{-1, -3}, 0, {}}, {{0.8, -3}, 0, {}}, {{-0.5, -0.5}, 0, {}}};
  return scene;
}

struct Outcome {
  double deepest = 0;  ///< of the tip below the face or the floor
  Point end;           ///< of the tip
};

Outcome outcome_of(const Wedge& wedge, double low_right) {
  Analysis analysis = support::plain_analysis(kTimeStep, static_cast<int>(kTime / kTimeStep));
  analysis.joint_materials[0].friction_angle_deg = 2;
  const Blocks scene = scene_of(wedge, low_right);
  StandardStepper stepper(support::standard_scene_of(scene, analysis, support::standard_settings(analysis)));
  const VertexIndex tip{5};
  const Point up = along(wedge.slope);
  Outcome outcome;
  for (double time = 0; time < kTime; time += kTimeStep) {
    support::run_to(stepper, time + kTimeStep);
    outcome.end = stepper.state().vertices[tip];
    outcome.deepest = std::max({outcome.deepest, -outcome.end.y, -cross(up, outcome.end)});
  }
  return outcome;
}

class ReflexCorner : public testing::TestWithParam<Wedge> {};

}  // namespace

TEST_P(ReflexCorner, stops_a_tip_on_both_faces) {
  const Outcome narrow = outcome_of(GetParam(), 1), wide = outcome_of(GetParam(), 8);
  EXPECT_LT(narrow.deepest, kDeepest);
  EXPECT_LT(wide.deepest, kDeepest);
  EXPECT_LT(distance(narrow.end, wide.end), 1e-3) << "the block below the faces does not matter";
}

INSTANTIATE_TEST_SUITE_P(wedges, ReflexCorner,
                         testing::Values(Wedge{30, 40, 70}, Wedge{45, 0, 30}, Wedge{45, 5, 60}, Wedge{60, 5, 20},
                                         Wedge{60, 40, 70}, Wedge{90, 5, 20}, Wedge{90, 5, 60}));

}  // namespace keyblock::reflex_corner_test
