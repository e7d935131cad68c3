// Trials of strength reduction that take long: what runs, how far it is, and an end to those that go beyond a limit.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

namespace keyblock {

/// Tells of a trial that takes more than two seconds, every second on a terminal and every five in a log: its factor,
/// for how long by now, how far the search is, and what the others took. Nothing under --quiet. A trial beyond the
/// limit is asked to stop as a signal would.
class TrialWatch {
 public:
  /// As `trial_limit` has them.
  TrialWatch(std::optional<double> asked, int unknowns);
  ~TrialWatch();
  TrialWatch(const TrialWatch&) = delete;
  TrialWatch& operator=(const TrialWatch&) = delete;

  void begin(double factor);
  void end();
  /// Whether the trial was asked to stop for its time; it is no request of the user's then, and is forgotten.
  bool takes_back_stop();
  /// Of the present trial, in seconds; nothing where there is none.
  std::optional<double> limit() const { return limit_; }

 private:
  using Clock = std::chrono::steady_clock;

  void watch();
  void tell(Clock::time_point now);
  double seconds_so_far(Clock::time_point now) const;

  std::optional<double> asked_;
  int unknowns_;
  std::optional<double> limit_;
  bool on_terminal_;
  std::optional<double> factor_;  ///< of the trial that runs
  Clock::time_point begun_;
  Clock::time_point told_;
  int made_ = 0;
  double taken_ = 0;           ///< seconds, by those that ended
  double longest_ = 0;         ///< of those that were not given up
  bool is_given_up_ = false;   ///< asked to stop
  bool was_given_up_ = false;  ///< and did
  bool is_hint_told_ = false;
  bool line_open_ = false;
  std::mutex mutex_;
  std::condition_variable wakes_;
  bool is_over_ = false;
  std::thread watching_;
};

}  // namespace keyblock
