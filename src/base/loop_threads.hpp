// Holds the threads of loops, which a context hands on. Only loops include TBB.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tbb/task_arena.h>

#include <memory>

namespace keyblock {

/// Threads for the loops of a context. They start with the first loop.
struct LoopThreads {
  explicit LoopThreads(int wanted) : count(wanted), arena(wanted) {}

  int count;
  tbb::task_arena arena;
};

/// Returns threads of this number; 0: as many as there are processors.
std::shared_ptr<LoopThreads> loop_threads_of(int count);

}  // namespace keyblock
