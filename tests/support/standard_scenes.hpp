// Builds small scenes for Dynamics::standard: a floor fixed by two points, squares on it, and a run to a given time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "model/kinematics.hpp"
#include "model/setup/choose_basis.hpp"
#include "step/standard_stepper.hpp"
#include "tests/support/scenes.hpp"

namespace keyblock::support {

inline double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

/// A rectangle in axes rotated by `angle`, origin fixed.
inline BlockPolygon turned_rectangle(Point low, Point high, double angle) {
  BlockPolygon block = rectangle(low, high);
  for (BlockVertex& corner : block.outer) corner.position = turned(corner.position, angle);
  return block;
}

/// Block 1, fixed: 20 m long, its top through the origin, falling to the right at `slope`. Block 2: a square metre on
/// it.
inline Blocks block_on_slope(double slope) {
  Blocks scene;
  scene.blocks = {turned_rectangle({0, -2}, {20, 0}, -slope), turned_rectangle({1, 0}, {2, 1}, -slope)};
  scene.fixed_points = {{turned(Point{1, -1}, -slope), 0, {}}, {turned(Point{19, -1}, -slope), 0, {}}};
  return scene;
}

inline Settings standard_settings(const Analysis& analysis) {
  return profile_settings("standard", analysis);
}

inline Scene standard_scene_of(const Blocks& blocks, const Analysis& analysis, const Settings& settings) {
  Model model = with_bases(model_from_blocks(blocks, analysis), settings.basis);
  return {std::move(model), settings};
}

/// Makes steps until `time`; a failed step throws.
inline void run_to(StandardStepper& stepper, double time) {
  const double half = stepper.scene().settings.time_step / 2;
  while (stepper.state().time < time - half) {
    const auto made = stepper.advance();
    if (const auto* failure = std::get_if<StepFailure>(&made)) throw std::runtime_error(failure->reason);
  }
}

/// Returns the displacement of the centroid of element `e` since the first step began.
template <class Start>  // a state, or the unloaded places
Point travel(const StandardStepper& stepper, const Start& start, int e) {
  return stepper.state().elements[ElementIndex{e}].centroid - start.elements[ElementIndex{e}].centroid;
}

}  // namespace keyblock::support
