// Runs a thread during the search that prints progress at intervals.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/strength/trial_watch.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "app/messages.hpp"
#include "app/progress.hpp"
#include "base/context.hpp"
#include "base/counted.hpp"

namespace keyblock {
namespace {

constexpr double kPatienceWithTrials = 2;
constexpr double kBetweenLines = 5;  // seconds, in a log
constexpr double kLeastShareOfTrial = 0.02;

}  // namespace

TrialWatch::TrialWatch() : on_terminal_(isatty(STDERR_FILENO) == 1), context_(context()) {
  context_.tell(nullptr, 0);
  if (shows_progress()) watching_ = std::thread([this] { watch(); });
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
  context_.tell(nullptr, 0);
  factor_ = factor;
  begun_ = told_ = Clock::now();
  wakes_.notify_one();
}

void TrialWatch::end() {
  const std::lock_guard lock(mutex_);
  if (!factor_) return;
  factor_.reset();
  ++made_;
  taken_ += seconds_so_far(Clock::now());
  if (line_open_) std::fputs("\r\x1b[K", stderr);
  line_open_ = false;
}

void TrialWatch::tell(Clock::time_point now) {
  const double so_far = seconds_so_far(now);
  const double since = std::chrono::duration<double>(now - told_).count();
  if (!shows_progress() || so_far < kPatienceWithTrials || (!on_terminal_ && since < kBetweenLines)) return;
  told_ = now;
  std::string words = fmt::format("trial {} (F = {:.4g}): {} so far", made_ + 1, *factor_, time_in_words(so_far));
  if (const Headway way = context_.headway(); way.what != nullptr) {
    words += fmt::format("; {}", way.what);
    if (way.share >= kLeastShareOfTrial) words += fmt::format(", {:.0f} % done", 100 * way.share);
  }
  if (made_ > 0)
    words += fmt::format("; {} before took {} on average", counted(static_cast<std::size_t>(made_), "trial"),
                         time_in_words(taken_ / made_));
  std::fputs((on_terminal_ ? "\r\x1b[K" + words : words + "\n").c_str(), stderr);
  std::fflush(stderr);
  line_open_ = on_terminal_;
}

void TrialWatch::watch() {
  std::unique_lock lock(mutex_);
  while (!is_over_) {
    wakes_.wait_for(lock, std::chrono::seconds(1));
    if (factor_ && !is_over_) tell(Clock::now());
  }
}

}  // namespace keyblock
