// Counts the linear systems that a computation solves, and stops it beyond a limit.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace keyblock {

/// Limits the linear systems that this thread solves while the object lives. Nothing: no limit, systems are counted
/// only. A count does not depend on the machine or its load, as seconds do.
class SystemLimit {
 public:
  explicit SystemLimit(std::optional<long long> most);
  ~SystemLimit();
  SystemLimit(const SystemLimit&) = delete;
  SystemLimit& operator=(const SystemLimit&) = delete;

  long long solved() const;
  bool is_reached() const;
};

/// Counts one linear system; to be called before it is solved, not within base/loop, whose threads have own counts.
/// Throws StopRequested if a stop was requested, or if the limit of this thread is reached.
void begin_system();

}  // namespace keyblock
