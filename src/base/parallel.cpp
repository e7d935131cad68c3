// Distributes work by a counter that the threads share.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "base/context.hpp"

namespace keyblock {
namespace {

constexpr std::size_t kBytesWorthAThread = 2000000;  // some milliseconds of work; starting a thread takes 0.05
constexpr std::size_t kMostThreads = 8;              // memory is no faster for more

}  // namespace

void for_each_in_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr first_error;
  std::mutex guard;
  const Context& caller = context();
  const auto take_and_work = [&] {
    const Under under(caller);
    for (std::size_t i = next++; i < count && !caller.is_stopped(); i = next++) {
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
  const Context& caller = context();
  std::vector<std::jthread> others;
  for (std::size_t i = 0; i + 1 < count; ++i)
    others.emplace_back([&, i] {
      const Under under(caller);
      work(i);
    });
  if (count > 0) work(count - 1);
}

std::size_t threads_for_bytes(std::size_t bytes) {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  return std::clamp<std::size_t>(bytes / kBytesWorthAThread, 1, std::min(cores, kMostThreads));
}

}  // namespace keyblock
