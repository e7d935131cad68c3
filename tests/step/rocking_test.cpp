// A tilted block rocks from corner to corner on a fixed floor (benchmark dda-16).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/standard_scenes.hpp"

namespace keyblock::rocking_test {
namespace {

using support::plain_analysis;
using support::rectangle;
using support::standard_scene_of;
using support::standard_settings;
using support::turned_rectangle;

constexpr double kGravity = 9.81;
constexpr std::size_t kPeaks = 4;
constexpr double kClose = 0.005;  // required at 1 ms; 0.003 was measured at most

struct Shape {
  double width = 0;
  double height = 0;
  double tilt = 0;  ///< rad
};

// The heights of the first peaks: θ'' = -3g/(4R) sin(α - θ) between impacts, tan α = b/h, and at each the rate falls to
// 1 - 1.5 sin² α of its value (Housner 1963). Steps of 10 μs by Störmer and Verlet.
std::vector<double> peaks_by_housner(const Shape& shape) {
  const double radius = std::hypot(shape.width, shape.height) / 2;
  const double alpha = std::atan2(shape.width, shape.height);
  const double kept = 1 - 1.5 * std::sin(alpha) * std::sin(alpha);
  const double dt = 1e-5;
  const auto acceleration = [&](double angle) { return -3 * kGravity / (4 * radius) * std::sin(alpha - angle); };
  std::vector<double> peaks;
  double angle = shape.tilt;
  double rate = 0;
  while (peaks.size() < kPeaks) {
    const double half = rate + acceleration(angle) * dt / 2;
    angle += half * dt;
    const double next = half + acceleration(angle) * dt / 2;
    if (rate > 0 && next <= 0) peaks.push_back(angle);
    rate = next;
    if (angle >= 0 || rate >= 0) continue;
    angle = -angle;
    rate *= -kept;
  }
  return peaks;
}

// Heights of the first peaks of a run, from parabolas through three steps.
std::vector<double> peaks_of_run(const Shape& shape, BlockBasis basis, double dt) {
  Blocks blocks;
  blocks.blocks = {rectangle({-5, -1}, {5, 0}), turned_rectangle({0, 0}, {shape.width, shape.height}, shape.tilt)};
  blocks.fixed_points = {{{-4, -0.5}, 0, {}}, {{4, -0.5}, 0, {}}};
  Analysis analysis = plain_analysis(dt, 1);
  analysis.gravity = kGravity;
  analysis.joint_materials[0].friction_angle_deg = 60;
  Settings settings = standard_settings(analysis);
  settings.basis = basis;
  const Scene scene = standard_scene_of(blocks, analysis, settings);
  StandardStepper stepper(scene);
  std::vector<double> peaks;
  bool has_struck = false;
  double before = shape.tilt;
  double last = shape.tilt;
  while (peaks.size() < kPeaks && stepper.state().time < 10) {
    support::run_to(stepper, stepper.state().time + dt);
    const double now = std::abs(shape.tilt + stepper.state().elements[ElementIndex{1}].rotation);
    const double bend = before - 2 * last + now;
    has_struck = has_struck || now < shape.tilt / 10;
    if (has_struck && last > before && last >= now)
      peaks.push_back(last - (now - before) * (now - before) / (8 * bend));
    before = last;
    last = now;
  }
  return peaks;
}

}  // namespace

// An impact releases the old corner at its instant, not at the end of the step.
TEST(Rocking, peaks_fall_as_housner_says_at_any_step) {
  for (const Shape& shape : {Shape{0.5, 1.6, 0.15}, Shape{1, 2, 0.25}, Shape{0.6, 3, 0.12}}) {
    const std::vector<double> expected = peaks_by_housner(shape);
    for (const BlockBasis basis : {BlockBasis::rigid, BlockBasis::affine})
      for (const double dt : {5e-3, 2e-3, 1e-3}) {
        const std::vector<double> found = peaks_of_run(shape, basis, dt);
        ASSERT_EQ(found.size(), kPeaks);
        for (std::size_t i = 0; i < kPeaks; ++i)
          EXPECT_NEAR(found[i], expected[i], kClose * expected[i]) << shape.height << ", dt " << dt << ", peak " << i;
      }
  }
}

}  // namespace keyblock::rocking_test
