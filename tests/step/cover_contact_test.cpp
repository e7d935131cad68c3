// Contact of bodies on covers, against theory and against the same bodies as blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/cover_scenes.hpp"

namespace keyblock {
namespace {

using testing::block_on_slope;
using testing::mixed_scene_of;
using testing::plain_analysis;
using testing::radians;
using testing::run_to;
using testing::standard_settings;

constexpr double kGravity = 9.81;

Scene slope(double slope_deg, double friction_deg, double dt, CoverFunctions functions, int half_rows,
            Enforcement enforcement) {
  Analysis analysis = plain_analysis(dt, 1);
  analysis.block_materials[0].density = 2600;
  analysis.block_materials[0].unit_weight = 2600 * kGravity;
  analysis.penalty_factor = 10;
  analysis.joint_materials[0].friction_angle_deg = friction_deg;
  Settings settings = standard_settings(analysis);
  settings.standard.enforcement = enforcement;
  return mixed_scene_of(block_on_slope(radians(slope_deg)), {1}, analysis, settings, half_rows, functions);
}

Point mass_centre(const StandardStepper& stepper) {
  const State& state = stepper.state();
  Point sum;
  double area = 0;
  for (ElementIndex e : indices(state.elements)) {
    if (!stepper.scene().model.elements[e].is_on_covers()) continue;
    area += state.elements[e].moments.area;
    sum = sum + state.elements[e].moments.area * state.elements[e].centroid;
  }
  return (1 / area) * sum;
}

TEST(CoverContact, explore) {
  for (const Enforcement enforcement : {Enforcement::penalty, Enforcement::lagrange})
    for (const CoverFunctions functions : {CoverFunctions::constant, CoverFunctions::derived, CoverFunctions::linear})
      for (const int rows : {1, 2, 4}) {
        const Scene scene = slope(30, 20, 1e-3, functions, rows, enforcement);
        StandardStepper stepper(scene);
        const Point start = mass_centre(stepper);
        try {
          run_to(stepper, 0.2);
        } catch (const std::exception& e) {
          fmt::print("failed at {}: {}\n", stepper.state().time, e.what());
        }
        const double t = stepper.state().time;
        const Point way = mass_centre(stepper) - start;
        const double a = radians(30);
        const double along = way.x * std::cos(a) - way.y * std::sin(a);
        const double off = way.x * std::sin(a) + way.y * std::cos(a);
        const double theory = kGravity / 2 * (std::sin(a) - std::cos(a) * std::tan(radians(20))) * t * t;
        fmt::print("{} {} rows {}: elements {}, slid {:.6f} of {:.6f}, error {:.2e}, off {:.2e}\n",
                   enforcement == Enforcement::penalty ? "penalty" : "multipliers", name_of(functions), rows,
                   scene.model.elements.size() - 1, along, theory, along / theory - 1, off);
      }
}

}  // namespace
}  // namespace keyblock
