// Runs independent pieces of work on several threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace keyblock {

/// Calls `work` for 0 … count - 1, each thread taking the next, until done or until the context of the caller is
/// stopped. After an exception no new piece begins, and the first one is rethrown after all threads have ended.
void for_each_in_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

/// Calls `work` for 0 … count - 1, each on a thread of its own; the last on the caller's. `work` must not throw.
void at_once(std::size_t count, const std::function<void(std::size_t)>& work);

/// Returns the number of threads worth starting for so many bytes of memory-bound work; at least 1.
std::size_t threads_for_bytes(std::size_t bytes);

}  // namespace keyblock
