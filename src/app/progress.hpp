// The progress line of a run on standard error: steps, dt, passes, time left.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "app/step_pace.hpp"
#include "base/context.hpp"
#include "result/step_report.hpp"

namespace keyblock {

/// "40 s", "12 min", "3.5 h", "2.1 days".
std::string time_in_words(double seconds);

/// On a terminal one line renewed a few times a second; elsewhere a line now and then. Between steps that take long,
/// and in the search for the start or for an equilibrium, it says for how long by now, how far it is and how much time
/// is left, as far as the search tells that. After the first few steps of a long run a line of its own says what a step
/// and all of them cost. Nothing under --quiet.
class ProgressLine {
 public:
  /// `steps_done`: by an earlier part of the run. `cheaper`: what would make steps cheaper, for the forecast; or empty.
  ProgressLine(int step_count, int steps_done, std::string cheaper);
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
  void forecast(Clock::time_point now);
  double seconds_left() const { return pace_.seconds_a_step() * (step_count_ - step_); }

  int step_count_;
  int steps_done_;
  std::string cheaper_;
  bool on_terminal_;
  Clock::time_point started_;
  Clock::time_point shown_;
  StepPace pace_;
  Clock::time_point forecast_from_;  ///< when the first step was made
  Clock::time_point stepped_;        ///< when the last step was made
  int step_;                         ///< the last that was made
  Context context_;                  ///< of the run
  bool line_open_ = false;
  bool is_forecast_ = false;
  std::mutex mutex_;
  std::condition_variable wakes_;
  bool is_over_ = false;
  std::thread waiting_;
};

}  // namespace keyblock
