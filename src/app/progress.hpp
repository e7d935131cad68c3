// Prints the progress of a run on standard error: step, time, time left.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "app/step_pace.hpp"
#include "base/context.hpp"
#include "problem/run_choices.hpp"
#include "result/step_report.hpp"

namespace keyblock {

/// Returns "40 s", "12 min", "3.5 h", "2.1 days".
std::string time_in_words(double seconds);

/// Prints "step 120/300  t = 0.12 s  about 1 s left": on a terminal one line that is renewed, otherwise a line every
/// few seconds. During long steps, and during the search for an equilibrium, it shows the elapsed time and, if known,
/// the completed fraction. --verbose adds step size and iterations, and an estimate of the time of all steps. Silent
/// with --quiet.
class ProgressLine {
 public:
  /// `steps_done`: by an earlier part of the run. `cheaper`: a setting that makes steps cheaper, or empty; the estimate
  /// names it.
  ProgressLine(int step_count, int steps_done, std::string cheaper, Units units);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  void show(const StepReport& report);
  /// Ends the line.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  void show_waiting();
  std::string words_of_waiting(Clock::time_point now) const;
  std::string words_of_step(const StepReport& report) const;
  void forecast(Clock::time_point now);
  double seconds_left() const { return pace_.seconds_a_step() * (step_count_ - step_); }

  int step_count_;
  int steps_done_;
  std::string cheaper_;
  Units units_;
  bool on_terminal_;
  Clock::time_point started_;
  Clock::time_point shown_;
  StepPace pace_;
  Clock::time_point forecast_from_;  ///< time of the first step
  Clock::time_point stepped_;        ///< time of the last step
  int step_;                         ///< last completed step
  Context context_;                  ///< of the run
  bool line_open_ = false;
  bool is_forecast_ = false;
  std::mutex mutex_;
  std::condition_variable wakes_;
  bool is_over_ = false;
  std::thread waiting_;
};

}  // namespace keyblock
