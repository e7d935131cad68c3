// Estimates the cost of a run: performs its first steps, times them and discards the result.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "model/scene/scene.hpp"

namespace keyblock {

struct TrialSteps {
  int made = 0;
  double start_seconds = 0;  ///< to find the start
  double step_seconds = 0;   ///< average per step
  bool starts = false;       ///< the start was found within the time
  std::string failure;       ///< reason of a failed step; empty without failure

  /// Returns the estimated wall time of so many steps.
  double seconds_of(int steps) const { return start_seconds + step_seconds * steps; }
};

/// Makes steps for `seconds`, at most `most`, and stops within a step when the time is over. The time of that step
/// until then counts as one step. Throws std::invalid_argument for a scene that cannot be stepped, StopRequested if its
/// context is stopped.
TrialSteps trial_steps(const Scene& scene, double seconds, int most);

}  // namespace keyblock
