// Runs loops by TBB, which no other file includes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/loop.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <thread>
#include <vector>

#include "base/context.hpp"

namespace keyblock {
namespace {

// Limit above any request of a computation. TBB uses the least limit that anyone sets, so it is set once for all;
// without it a context would have no more threads than there are processors.
constexpr std::size_t kThreadLimit = 256;

}  // namespace

struct LoopThreads {
  explicit LoopThreads(int wanted) : count(wanted), arena(wanted) {}

  int count;
  tbb::task_arena arena;
};

std::shared_ptr<LoopThreads> loop_threads_of(int count) {
  static const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, kThreadLimit);
  // One arena for all contexts that set no number: several at once share the processors.
  static const auto usual =
      std::make_shared<LoopThreads>(static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
  return count > 0 ? std::make_shared<LoopThreads>(count) : usual;
}

int loop_threads() {
  return context().threads().count;
}

void for_ranges(std::size_t count, const std::function<void(std::size_t, std::size_t, std::size_t)>& work,
                Work weight) {
  const std::size_t ranges = range_count(count);
  const auto one = [&](std::size_t range) {
    work(range, range * kLoopRange, std::min(count, (range + 1) * kLoopRange));
  };
  const Context& caller = context();
  LoopThreads& threads = caller.threads();
  if (ranges < worth_waking(weight) || threads.count == 1) {
    for (std::size_t range = 0; range < ranges; ++range) one(range);
    return;
  }
  std::vector<std::exception_ptr> thrown(ranges);
  threads.arena.execute([&] {
    tbb::parallel_for(
        std::size_t{0}, ranges,
        [&](std::size_t range) {
          const Under under(caller);
          try {
            one(range);
          } catch (...) {
            thrown[range] = std::current_exception();
          }
        },
        tbb::static_partitioner());
  });
  for (const std::exception_ptr& error : thrown)
    if (error) std::rethrow_exception(error);
}

}  // namespace keyblock
