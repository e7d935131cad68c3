// Runs the steps in a context that stops after the given time.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/trial_steps.hpp"

#include <algorithm>
#include <chrono>

#include "base/context.hpp"
#include "run/steppers.hpp"

namespace keyblock {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point then) {
  return std::chrono::duration<double>(Clock::now() - then).count();
}

}  // namespace

TrialSteps trial_steps(const Scene& scene, double seconds, int most) {
  TrialSteps trial;
  const Context limited = context().part({.seconds = seconds});
  const Clock::time_point began = Clock::now();
  Clock::time_point stepped = began;
  try {
    const Under under(limited);
    const std::unique_ptr<Stepper> stepper = stepper_for(scene);
    trial.starts = true;
    trial.start_seconds = seconds_since(began);
    stepped = Clock::now();
    while (trial.made < most && !stepper->is_done() && !limited.is_stopped()) {
      const auto made = stepper->advance();
      if (const auto* failure = std::get_if<StepFailure>(&made)) {
        trial.failure = failure->reason;
        break;
      }
      ++trial.made;
    }
  } catch (const StopRequested&) {
    if (!trial.starts) trial.start_seconds = seconds_since(began);
  }
  leave_if_stopped();  // a stop of the outer context
  if (!trial.starts) return trial;
  trial.step_seconds = seconds_since(stepped) / std::max(1, trial.made);
  return trial;
}

}  // namespace keyblock
