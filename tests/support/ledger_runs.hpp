// Runs small scenes and returns their energy balance.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "result/ledger.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::support {

/// Returns all rows of a run to `time`; a failed step throws.
inline Ledger ledger_of(const Scene& scene, double time) {
  StandardStepper stepper(scene);
  Ledger ledger{stepper.ledger_scope(), {stepper.ledger()}};
  const double dt = scene.settings.time_step;
  while (stepper.state().time < time - dt / 2) {
    run_to(stepper, stepper.state().time + dt);
    ledger.rows.push_back(stepper.ledger());
  }
  return ledger;
}

/// A rectangle of 1 × `height` at rest on a floor that falls to the right at `slope`.
inline Blocks column_on_slope(double slope, double height) {
  Blocks scene = block_on_slope(slope);
  scene.blocks[1] = turned_rectangle({5, 0}, {6, height}, -slope);
  return scene;
}

/// A square metre above a fixed floor.
inline Blocks block_above_floor(double gap) {
  Blocks blocks;
  blocks.blocks = {rectangle({-2, -1}, {3, 0}), rectangle({0, gap}, {1, 1 + gap})};
  blocks.fixed_points = {{{-1, -0.5}, 0, {}}, {{2, -0.5}, 0, {}}};
  return blocks;
}

}  // namespace keyblock::support
