// Handles signals: the handler only records the request and prints a line.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/stop_request.hpp"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <string_view>

#include "base/context.hpp"

namespace keyblock {
namespace {

std::atomic<const Context*> listening = nullptr;
std::atomic<int> last_signal = 0;
std::atomic<std::int64_t> first_asked = 0;

// Programs that forward a signal may send it twice at once, as `timeout` does: only a later one counts as a second
// request.
constexpr std::int64_t kLater = 1'000;  // milliseconds

constexpr std::string_view kStopping = "stopping; a second request ends the program at once\n";

std::int64_t milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1'000 * static_cast<std::int64_t>(now.tv_sec) + now.tv_nsec / 1'000'000;
}

// Only calls that are safe in a handler. The limit of processor time sends a signal every second.
extern "C" void remember_signal(int signal) {
  const int error = errno;
  last_signal = signal;
  listening.load()->stop();
  if (signal != SIGXCPU) {
    const std::int64_t now = milliseconds();
    if (first_asked == 0) {
      first_asked = now;
      [[maybe_unused]] const auto written = write(STDERR_FILENO, kStopping.data(), kStopping.size());
    } else if (now - first_asked >= kLater) {
      std::signal(signal, SIG_DFL);
      std::raise(signal);
    }
  }
  errno = error;
}

}  // namespace

void listen_for_stops() {
  static const Context& of_first = *new Context(context());  // signals may arrive until the very end
  listening = &of_first;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU})
    if (std::signal(signal, remember_signal) == SIG_IGN) std::signal(signal, SIG_IGN);  // as nohup requires
}

bool is_at_time_limit() {
  return last_signal == SIGXCPU;
}

}  // namespace keyblock
