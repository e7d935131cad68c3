// The progress line of a run on standard error: steps, dt, passes, time left.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "result/step_report.hpp"

namespace keyblock {

/// On a terminal one line renewed a few times a second; elsewhere a line now and then.
class ProgressLine {
 public:
  /// `steps_done`: by an earlier part of the run.
  ProgressLine(int step_count, int steps_done);
  void show(const StepReport& report);
  /// Ends the line.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  int step_count_;
  int steps_done_;
  bool on_terminal_;
  Clock::time_point started_;
  Clock::time_point shown_;
  bool line_open_ = false;
};

}  // namespace keyblock
