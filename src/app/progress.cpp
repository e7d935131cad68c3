// Formats and times the progress line.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "app/messages.hpp"
#include "base/context.hpp"
#include "base/counted.hpp"
#include "problem/units/readable.hpp"

namespace keyblock {
namespace {

constexpr double kTerminalSeconds = 0.2;  // between two renewals on a terminal
constexpr double kLogSeconds = 5;         // between two lines in a log

// Returns the seconds between two lines in a log; the window of `serve` asks for more of them.
double log_seconds() {
  static const double kSeconds = [] {
    const char* given = std::getenv("KEYBLOCK_LOG_SECONDS");
    const double asked = given == nullptr ? 0 : std::strtod(given, nullptr);
    return asked > 0 ? asked : kLogSeconds;
  }();
  return kSeconds;
}
constexpr double kPatience = 2;         // seconds without a step until the elapsed time is shown
constexpr double kLeastShare = 0.02;    // fraction of a search from which its end is estimated
constexpr double kForecastSeconds = 2;  // seconds of stepping, or this many steps, before the total time is estimated
constexpr int kForecastSteps = 20;
constexpr double kLeastLeft = 0.5;  // seconds, which would be rounded to 0
constexpr double kLongRun = 20;     // seconds left; below this no estimate is shown

double seconds(std::chrono::steady_clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

// Errors of writing are ignored: the run continues if nobody reads its progress.
void show(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace

std::string time_in_words(double seconds) {
  constexpr double kMinute = 60, kHour = 3600, kDay = 86400;
  if (seconds < 2 * kMinute) return fmt::format("{:.0f} s", seconds);
  if (seconds < 2 * kHour) return fmt::format("{:.0f} min", seconds / kMinute);
  if (seconds < 2 * kDay) return fmt::format("{:.1f} h", seconds / kHour);
  return fmt::format("{:.1f} days", seconds / kDay);
}

ProgressLine::ProgressLine(int step_count, int steps_done, std::string cheaper, Units units)
    : step_count_(step_count),
      steps_done_(steps_done),
      cheaper_(std::move(cheaper)),
      units_(std::move(units)),
      on_terminal_(isatty(STDERR_FILENO) == 1),
      started_(Clock::now()),
      shown_(started_),
      forecast_from_(started_),
      stepped_(started_),
      step_(steps_done),
      context_(context()) {
  context_.tell(nullptr, 0);
  if (shows_progress()) waiting_ = std::thread([this] { show_waiting(); });
}

ProgressLine::~ProgressLine() {
  finish();
}

// The remaining time of a search is estimated from that of its completed part.
std::string ProgressLine::words_of_waiting(Clock::time_point now) const {
  const Headway way = context_.headway();
  std::string words = step_ == steps_done_ ? fmt::format("initial state and step {}", step_ + 1)
                                           : fmt::format("step {}/{}", step_ + 1, step_count_);
  words += fmt::format(": {:.0f} s so far", seconds(now - stepped_));
  if (way.what == nullptr) return words;
  words += fmt::format("; {}", way.what);
  if (way.share < kLeastShare) return words;
  const double left = seconds(now - stepped_) * (1 - way.share) / way.share;
  return words + fmt::format(", {:.0f} % done, about {} left", 100 * way.share, time_in_words(left));
}

std::string ProgressLine::words_of_step(const StepReport& report) const {
  std::string words =
      fmt::format("step {}/{}  t = {}", report.step, step_count_, readable(report.time, measures::kTime, units_));
  if (spdlog::should_log(spdlog::level::debug))
    words += fmt::format("  step size {}  {}", readable(report.dt, measures::kTime, units_),
                         counted(static_cast<std::size_t>(report.passes), "iteration"));
  if (report.step == step_count_) return words;
  const double left = seconds_left();
  return words + (left < kLeastLeft ? "  less than 1 s left" : fmt::format("  about {} left", time_in_words(left)));
}

void ProgressLine::forecast(Clock::time_point now) {
  const int made = step_ - steps_done_;
  if (is_forecast_ || made < 2 || (made < kForecastSteps && seconds(now - forecast_from_) < kForecastSeconds)) return;
  is_forecast_ = true;
  if (seconds_left() < kLongRun || !spdlog::should_log(spdlog::level::debug)) return;
  keyblock::show(fmt::format(
      "{}estimate after {}: {:.2g} s per step, about {} for the remaining {}{}\n", line_open_ ? "\r\x1b[K" : "",
      counted(static_cast<std::size_t>(made), "step"), pace_.seconds_a_step(), time_in_words(seconds_left()),
      step_count_ - step_,
      cheaper_.empty() ? "" : "; contact springs are stiff for this step size: " + cheaper_ + " makes steps cheaper"));
  line_open_ = false;
}

void ProgressLine::show_waiting() {
  std::unique_lock lock(mutex_);
  while (!wakes_.wait_for(lock, std::chrono::seconds(1), [this] { return is_over_; })) {
    const Clock::time_point now = Clock::now();
    if (seconds(now - stepped_) < kPatience || (!on_terminal_ && seconds(now - shown_) < log_seconds())) continue;
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
  if (step_ == steps_done_ + 1) forecast_from_ = now;
  pace_.made(step_ - steps_done_, seconds(now - started_));
  forecast(now);
  tell_headway(nullptr, 0);
  const bool last = report.step == step_count_;
  if (!last && seconds(now - shown_) < (on_terminal_ ? kTerminalSeconds : log_seconds())) return;
  shown_ = now;
  keyblock::show(
      fmt::format("{}{}{}", on_terminal_ ? "\r\x1b[K" : "", words_of_step(report), on_terminal_ ? "" : "\n"));
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
