// The handler does no more than remember.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/stop_request.hpp"

#include <atomic>
#include <csignal>

namespace keyblock {
namespace {

std::atomic<int> last_signal = 0;

// A second Ctrl-C ends the program at once. The limit of processor time signals every second.
extern "C" void remember_signal(int signal) {
  last_signal = signal;
  if (signal == SIGINT) std::signal(SIGINT, SIG_DFL);
}

}  // namespace

void listen_for_stops() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) std::signal(signal, remember_signal);
}

int stop_signal() {
  return last_signal;
}

bool is_at_time_limit() {
  return stop_signal() == SIGXCPU;
}

}  // namespace keyblock
