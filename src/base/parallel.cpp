// A counter that the threads share.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace keyblock {
namespace {

constexpr std::size_t kBytesWorthAThread = 2000000;  // some milliseconds of work; starting a thread takes 0.05
constexpr std::size_t kMostThreads = 8;              // memory is no faster for more

}  // namespace

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

void at_once(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::vector<std::jthread> others;
  for (std::size_t i = 0; i + 1 < count; ++i) others.emplace_back(work, i);
  if (count > 0) work(count - 1);
}

std::size_t threads_for_bytes(std::size_t bytes) {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  return std::clamp<std::size_t>(bytes / kBytesWorthAThread, 1, std::min(cores, kMostThreads));
}

}  // namespace keyblock
