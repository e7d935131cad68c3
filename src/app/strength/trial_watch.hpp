// Shows the progress of long trials of strength reduction.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "base/context.hpp"

namespace keyblock {

/// Reports a trial of more than two seconds, every second on a terminal and every five in a log. The report has the
/// reduction factor, the time so far, the progress of the search, and the mean time of earlier trials. Prints nothing
/// under --quiet.
class TrialWatch {
 public:
  TrialWatch();
  ~TrialWatch();
  TrialWatch(const TrialWatch&) = delete;
  TrialWatch& operator=(const TrialWatch&) = delete;

  void begin(double factor);
  void end();

 private:
  using Clock = std::chrono::steady_clock;

  void watch();
  void tell(Clock::time_point now);
  double seconds_so_far(Clock::time_point now) const;

  bool on_terminal_;
  Context context_;               ///< of the search
  std::optional<double> factor_;  ///< of the current trial
  Clock::time_point begun_;
  Clock::time_point told_;
  int made_ = 0;
  double taken_ = 0;  ///< seconds, of completed trials
  bool line_open_ = false;
  std::mutex mutex_;
  std::condition_variable wakes_;
  bool is_over_ = false;
  std::thread watching_;
};

}  // namespace keyblock
