// The progress line of a run on standard error: steps, dt, passes, time left.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "result/step_report.hpp"

namespace keyblock {

/// On a terminal one line renewed a few times a second; elsewhere a line now and then. Between steps that take long,
/// and in the search for the start or for an equilibrium, it says for how long by now, how far it is and how much time
/// is left, as far as the search tells that. Nothing under --quiet.
class ProgressLine {
 public:
  /// `steps_done`: by an earlier part of the run.
  ProgressLine(int step_count, int steps_done);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  void show(const StepReport& report);
  /// Ends the line.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  void tell_of_waiting();
  std::string words_of_waiting(Clock::time_point now) const;

  int step_count_;
  int steps_done_;
  bool on_terminal_;
  Clock::time_point started_;
  Clock::time_point shown_;
  Clock::time_point stepped_;  ///< when the last step was made
  int step_;                   ///< the last that was made
  bool line_open_ = false;
  std::mutex mutex_;
  std::condition_variable wakes_;
  bool is_over_ = false;
  std::thread waiting_;
};

}  // namespace keyblock
