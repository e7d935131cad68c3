// Formats and times the progress line.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace keyblock {
namespace {

constexpr double kTerminalSeconds = 0.2;  // between two renewals on a terminal
constexpr double kLogSeconds = 5;         // between two lines in a log

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
      shown_(started_) {}

void ProgressLine::show(const StepReport& report) {
  const Clock::time_point now = Clock::now();
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
  if (line_open_) keyblock::show("\n");
  line_open_ = false;
}

}  // namespace keyblock
