// One count for each thread.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/progress/system_limit.hpp"

#include "base/stop.hpp"

namespace keyblock {
namespace {

struct Systems {
  long long solved = 0;
  std::optional<long long> most;
};
thread_local Systems systems;

}  // namespace

SystemLimit::SystemLimit(std::optional<long long> most) {
  systems = {0, most};
}

SystemLimit::~SystemLimit() {
  systems.most.reset();
}

long long SystemLimit::solved() const {
  return systems.solved;
}

bool SystemLimit::is_reached() const {
  return systems.most && systems.solved >= *systems.most;
}

void begin_system() {
  leave_if_stopped();
  if (systems.most && systems.solved >= *systems.most) throw StopRequested();
  ++systems.solved;
}

}  // namespace keyblock
