// Runs loops by TBB.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/loop.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <exception>
#include <vector>

#include "base/context.hpp"
#include "base/loop_threads.hpp"

namespace keyblock {

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
