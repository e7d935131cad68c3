// A clock beside the steps requests the stop that long computations hear.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/trial_steps.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "base/stop.hpp"
#include "run/steppers.hpp"

namespace keyblock {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point then) {
  return std::chrono::duration<double>(Clock::now() - then).count();
}

/// Requests a stop once the time is over, unless it is gone before.
class Alarm {
 public:
  explicit Alarm(double seconds)
      : thread_([this, seconds] {
          std::unique_lock lock(mutex_);
          const bool is_over =
              !gone_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return is_gone_; });
          if (is_over) request_stop();
        }) {}
  ~Alarm() {
    {
      const std::lock_guard lock(mutex_);
      is_gone_ = true;
    }
    gone_.notify_one();
    thread_.join();
    forget_stop_request();
  }
  Alarm(const Alarm&) = delete;
  Alarm& operator=(const Alarm&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable gone_;
  bool is_gone_ = false;
  std::thread thread_;
};

}  // namespace

TrialSteps trial_steps(const Scene& scene, double seconds, int most) {
  TrialSteps trial;
  const Alarm alarm(seconds);
  const Clock::time_point began = Clock::now();
  Clock::time_point stepped = began;
  try {
    const std::unique_ptr<Stepper> stepper = stepper_for(scene);
    trial.starts = true;
    trial.start_seconds = seconds_since(began);
    stepped = Clock::now();
    while (trial.made < most && !stepper->is_done() && !is_stop_requested()) {
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
  if (!trial.starts) return trial;
  trial.step_seconds = seconds_since(stepped) / std::max(1, trial.made);
  return trial;
}

}  // namespace keyblock
