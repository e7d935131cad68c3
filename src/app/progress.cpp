// Formats and times the progress line.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "app/messages.hpp"
#include "base/progress/headway.hpp"

namespace keyblock {
namespace {

constexpr double kTerminalSeconds = 0.2;  // between two renewals on a terminal
constexpr double kLogSeconds = 5;         // between two lines in a log
constexpr double kPatience = 2;           // without a step, until that is told
constexpr double kLeastShare = 0.02;      // of a search, from which on its end is guessed

double seconds(std::chrono::steady_clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

// Nobody may be there to read it, or no room where it goes: the run goes on.
void show(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace

ProgressLine::ProgressLine(int step_count, int steps_done)
    : step_count_(step_count),
      steps_done_(steps_done),
      on_terminal_(isatty(STDERR_FILENO) == 1),
      started_(Clock::now()),
      shown_(started_),
      stepped_(started_),
      step_(steps_done) {
  forget_headway();
  if (shows_progress()) waiting_ = std::thread([this] { tell_of_waiting(); });
}

ProgressLine::~ProgressLine() {
  finish();
}

// A search tells its share of the way; what is left would take as long as that took.
std::string ProgressLine::words_of_waiting(Clock::time_point now) const {
  const Headway way = headway();
  std::string words = step_ == steps_done_ ? fmt::format("start and step {}", step_ + 1)
                                           : fmt::format("step {} of {}", step_ + 1, step_count_);
  words += fmt::format(": {:.0f} s so far", seconds(now - stepped_));
  if (way.what == nullptr) return words;
  words += fmt::format("; {}", way.what);
  if (way.share < kLeastShare) return words;
  words += fmt::format(", about {:.0f} % of the way", 100 * way.share);
  const double left = seconds(now - stepped_) * (1 - way.share) / way.share;
  return words + fmt::format(", {:.0f} s left", left);
}

void ProgressLine::tell_of_waiting() {
  std::unique_lock lock(mutex_);
  while (!wakes_.wait_for(lock, std::chrono::seconds(1), [this] { return is_over_; })) {
    const Clock::time_point now = Clock::now();
    if (seconds(now - stepped_) < kPatience || (!on_terminal_ && seconds(now - shown_) < kLogSeconds)) continue;
    shown_ = now;
    keyblock::show(
        fmt::format("{}{}{}", on_terminal_ ? "\r\x1b[K" : "", words_of_waiting(now), on_terminal_ ? "" : "\n"));
    line_open_ = on_terminal_;
  }
}

void ProgressLine::show(const StepReport& report) {
  if (!shows_progress()) return;
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  stepped_ = now;
  step_ = report.step;
  forget_headway();
  const bool last = report.step == step_count_;
  if (!last && seconds(now - shown_) < (on_terminal_ ? kTerminalSeconds : kLogSeconds)) return;
  shown_ = now;
  const double left = seconds(now - started_) / (report.step - steps_done_) * (step_count_ - report.step);
  keyblock::show(fmt::format("{}step {} of {}  time {:.6g}  dt {:.4g}  passes {}  {:.0f} s left{}",
                             on_terminal_ ? "\r\x1b[K" : "", report.step, step_count_, report.time, report.dt,
                             report.passes, left, on_terminal_ ? "" : "\n"));
  line_open_ = on_terminal_;
}

void ProgressLine::finish() {
  if (waiting_.joinable()) {
    {
      const std::lock_guard lock(mutex_);
      is_over_ = true;
    }
    wakes_.notify_one();
    waiting_.join();
  }
  if (line_open_) keyblock::show("\n");
  line_open_ = false;
}

}  // namespace keyblock
