// The handler does no more than remember, and say so.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/stop_request.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <ctime>
#include <string_view>

namespace keyblock {
namespace {

std::atomic<int> last_signal = 0;
std::atomic<std::time_t> first_interrupt = 0;

// Programs that pass an interrupt on may send it twice at once: only one that comes later is a second one.
constexpr std::time_t kLater = 2;  // seconds

constexpr std::string_view kStopping = "stopping after the step at hand; Ctrl-C again in two seconds ends it at once\n";

// What is done here is safe in a handler. The limit of processor time signals every second.
extern "C" void remember_signal(int signal) {
  last_signal = signal;
  if (signal != SIGINT) return;
  const std::time_t now = std::time(nullptr);
  if (first_interrupt == 0) {
    first_interrupt = now;
    [[maybe_unused]] const auto written = write(STDERR_FILENO, kStopping.data(), kStopping.size());
  } else if (now - first_interrupt >= kLater) {
    std::signal(SIGINT, SIG_DFL);
    std::raise(SIGINT);
  }
}

}  // namespace

void listen_for_stops() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU})
    if (std::signal(signal, remember_signal) == SIG_IGN) std::signal(signal, SIG_IGN);  // as nohup asks for
}

int stop_signal() {
  return last_signal;
}

bool is_at_time_limit() {
  return stop_signal() == SIGXCPU;
}

}  // namespace keyblock
