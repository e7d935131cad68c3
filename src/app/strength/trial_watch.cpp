// A thread beside the search, which looks at the clock.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/strength/trial_watch.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "app/messages.hpp"
#include "app/progress.hpp"
#include "app/strength/trial_limit.hpp"
#include "base/counted.hpp"
#include "base/progress/headway.hpp"
#include "base/stop.hpp"

namespace keyblock {
namespace {

constexpr double kPatienceWithTrials = 2;
constexpr double kBetweenLines = 5;  // in a log
constexpr double kLongTrial = 30;    // after which the limit is told of
constexpr double kLeastShareOfTrial = 0.02;

}  // namespace

TrialWatch::TrialWatch(std::optional<double> asked, int unknowns)
    : asked_(asked), unknowns_(unknowns), on_terminal_(isatty(STDERR_FILENO) == 1) {
  forget_headway();
  if (!asked || *asked > 0 || shows_progress()) watching_ = std::thread([this] { watch(); });
}

TrialWatch::~TrialWatch() {
  if (!watching_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  wakes_.notify_one();
  watching_.join();
  if (line_open_) std::fputs("\n", stderr);
}

double TrialWatch::seconds_so_far(Clock::time_point now) const {
  return std::chrono::duration<double>(now - begun_).count();
}

void TrialWatch::begin(double factor) {
  const std::lock_guard lock(mutex_);
  forget_headway();
  factor_ = factor;
  limit_ = trial_limit(asked_, unknowns_, longest_);
  begun_ = told_ = Clock::now();
  is_given_up_ = was_given_up_ = false;
  wakes_.notify_one();
}

void TrialWatch::end() {
  const std::lock_guard lock(mutex_);
  if (!factor_) return;
  factor_.reset();
  ++made_;
  const double seconds = seconds_so_far(Clock::now());
  taken_ += seconds;
  if (!was_given_up_) longest_ = std::max(longest_, seconds);
  if (std::exchange(is_given_up_, false)) forget_stop_request();  // it came to its end in that very moment
  if (line_open_) std::fputs("\r\x1b[K", stderr);
  line_open_ = false;
}

bool TrialWatch::takes_back_stop() {
  const std::lock_guard lock(mutex_);
  if (!is_given_up_) return false;
  is_given_up_ = false;
  was_given_up_ = true;
  forget_stop_request();
  return true;
}

void TrialWatch::tell(Clock::time_point now) {
  const double so_far = seconds_so_far(now);
  const double since = std::chrono::duration<double>(now - told_).count();
  if (!shows_progress() || so_far < kPatienceWithTrials || (!on_terminal_ && since < kBetweenLines)) return;
  told_ = now;
  std::string words = fmt::format("F = {:.6g}: trial {}, {} so far", *factor_, made_ + 1, time_in_words(so_far));
  if (const Headway way = headway(); way.what != nullptr) {
    words += fmt::format("; {}", way.what);
    if (way.share >= kLeastShareOfTrial) words += fmt::format(", about {:.0f} % of the way", 100 * way.share);
  }
  if (made_ > 0)
    words += fmt::format("; the {} before took {} in the mean", counted(static_cast<std::size_t>(made_), "trial"),
                         time_in_words(taken_ / made_));
  if (limit_) words += fmt::format("; given up at {}", time_in_words(*limit_));
  if (!asked_ && !is_hint_told_ && so_far > kLongTrial) {
    is_hint_told_ = true;
    words += "; --trial-limit SECONDS sets another limit, 0 none";
  }
  std::fputs((on_terminal_ ? "\r\x1b[K" + words : words + "\n").c_str(), stderr);
  std::fflush(stderr);
  line_open_ = on_terminal_;
}

void TrialWatch::watch() {
  std::unique_lock lock(mutex_);
  while (!is_over_) {
    auto wait = std::chrono::duration<double>(1);
    if (factor_ && limit_ && !is_given_up_)
      wait = std::min(wait, std::chrono::duration<double>(std::max(0.0, *limit_ - seconds_so_far(Clock::now()))));
    wakes_.wait_for(lock, wait);
    if (!factor_ || is_over_) continue;
    const Clock::time_point now = Clock::now();
    if (limit_ && !is_given_up_ && seconds_so_far(now) >= *limit_) {
      is_given_up_ = true;
      request_stop();
    }
    tell(now);
  }
}

}  // namespace keyblock
