// One flag.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/stop.hpp"

#include <atomic>

namespace keyblock {
namespace {

std::atomic<bool> is_requested = false;
static_assert(std::atomic<bool>::is_always_lock_free, "signal handlers may set it");

}  // namespace

void request_stop() {
  is_requested = true;
}

bool is_stop_requested() {
  return is_requested.load(std::memory_order_relaxed);
}

void forget_stop_request() {
  is_requested = false;
}

void leave_if_stopped() {
  if (is_stop_requested()) throw StopRequested();
}

}  // namespace keyblock
