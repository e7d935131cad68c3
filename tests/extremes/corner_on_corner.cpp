// ext-10: symmetric scenes stay symmetric when corners meet corners.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "tests/extremes/extreme.hpp"
#include "tests/extremes/extreme_scenes.hpp"

namespace keyblock::extremes {
namespace {

constexpr double kMostDrift = 1e-9;

// A unit square that stands on a corner at `foot`.
BlockPolygon on_corner(Point foot) {
  const double half = std::sqrt(0.5);
  return polygon({foot, foot + Point{half, half}, foot + Point{0, 2 * half}, foot + Point{-half, half}});
}

Extreme dropped(const std::string& what, const Blocks& blocks, double dt, double time, double friction_deg) {
  Problem problem;
  problem.geometry = blocks;
  problem.analysis = plain_analysis(dt, static_cast<int>(std::lround(time / dt)));
  problem.analysis->joint_materials[0].friction_angle_deg = friction_deg;
  const Run run = run_standard(problem);
  const std::size_t falling = blocks.blocks.size() - 1;
  return {"ext-10",   fmt::format("{}, dt {:g} s, friction {:g}: x-drift", what, dt, friction_deg),
          0,          std::abs(run.travel(falling).x) + std::abs(run.block(falling).rotation),
          kMostDrift, run.trouble};
}

// The upper square falls 5 cm onto the corner of a fixed one.
Blocks corner_to_corner() {
  return scene_of_blocks({on_corner({0, -2 * std::sqrt(0.5)})}, {on_corner({0, 0.05})});
}

// A wedge of 60 degrees falls 5 cm into the notch between two fixed triangles.
Blocks into_notch() {
  const double run = std::tan(radians(30));
  const BlockPolygon left = polygon({{0, 0}, {-run, 1}, {-2, 1}, {-2, 0}});
  const BlockPolygon right = polygon({{0, 0}, {2, 0}, {2, 1}, {run, 1}});
  return scene_of_blocks({left, right}, {polygon({{0, 0.05}, {run, 1.05}, {-run, 1.05}})});
}

// A square falls 5 cm flat onto the corner of a fixed one.
Blocks flat_on_corner() {
  return scene_of_blocks({on_corner({0, -2 * std::sqrt(0.5)})}, {rectangle({-0.5, 0.05}, {0.5, 1.05})});
}

}  // namespace

Extremes corner_on_corner(Effort) {
  Extremes rows;
  for (const double dt : {1e-3, 5e-3}) {
    for (const double friction : {0.0, 30.0}) {
      // Up to the impact at 0.101 s and half as long after it.
      rows.push_back(dropped("corner on corner", corner_to_corner(), dt, 0.15, friction));
      rows.push_back(dropped("wedge into a notch", into_notch(), dt, 0.15, friction));
      rows.push_back(dropped("flat on a corner", flat_on_corner(), dt, 0.15, friction));
    }
  }
  return rows;
}

}  // namespace keyblock::extremes
