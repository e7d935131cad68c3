// Independent pieces of work on several threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace keyblock {

/// Does `work` for 0 … count - 1, each thread taking the next, until done or the context of the caller is stopped.
/// After an exception nothing new is begun, and the first is thrown again once all threads have ended.
void for_each_in_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

/// Does `work` for 0 … count - 1, each on a thread of its own; the last on the caller's. `work` must not throw.
void at_once(std::size_t count, const std::function<void(std::size_t)>& work);

/// Threads worth starting for that many bytes of work of the kind that memory keeps up with; 1 or more.
std::size_t threads_for_bytes(std::size_t bytes);

}  // namespace keyblock
