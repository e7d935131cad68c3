// A counter that the threads share.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/parallel.hpp"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace keyblock {

void for_each_in_parallel(std::size_t count, int threads, const std::function<bool()>& is_stopped,
                          const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr first_error;
  std::mutex guard;
  const auto take_and_work = [&] {
    for (std::size_t i = next++; i < count && !is_stopped(); i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::scoped_lock lock(guard);
        if (!first_error) first_error = std::current_exception();
        next = count;
      }
    }
  };
  {
    std::vector<std::jthread> pool;
    for (int i = 0; i < threads; ++i) pool.emplace_back(take_and_work);
  }
  if (first_error) std::rethrow_exception(first_error);
}

}  // namespace keyblock
