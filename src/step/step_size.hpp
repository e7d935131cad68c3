// The size of the first and the next step, by rule or constant.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings.hpp"
#include "model/state.hpp"

namespace keyblock {

/// What the rule looks at.
struct StepHistory {
  double dt = 0;                  ///< last accepted step size
  double displacement_ratio = 0;  ///< of the last step
  double penetration = 0;         ///< greatest of the last step, length
  double penalty = 0;             ///< present contact stiffness
};

/// Step 1: reaches the allowed displacement under the greatest acceleration of weight, initial stress and
/// loads (Shi's rule; legacy-formats 3.4). `start_speed` is the largest start velocity component.
double first_step_size(const Model& model, const State& state, const Settings& settings, double start_speed);

/// Later steps: the same from penetration and loads, at most 1.3 times the last (legacy-rules 13; unconfirmed
/// beyond 20 steps).
double next_step_size(const Model& model, const State& state, const Settings& settings,
                      const StepHistory& last);

}  // namespace keyblock
