// What a run will cost: its first steps made, timed and thrown away.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "model/scene/scene.hpp"

namespace keyblock {

struct TrialSteps {
  int made = 0;
  double start_seconds = 0;  ///< to find the start
  double step_seconds = 0;   ///< of one step, in the mean
  bool starts = false;       ///< the start was found within the time
  std::string failure;       ///< why a step could not be made; empty where none failed

  /// Wall time of so many steps, as far as the first ones tell.
  double seconds_of(int steps) const { return start_seconds + step_seconds * steps; }
};

/// Makes steps for so many seconds, at most `most`, and stops in the middle of one where time is over: what that step
/// took until then counts as one. Throws std::invalid_argument for a scene that cannot be stepped,
/// StopRequested where its context is stopped.
TrialSteps trial_steps(const Scene& scene, double seconds, int most);

}  // namespace keyblock
