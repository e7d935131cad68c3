// The only file that sees TBB.
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

namespace keyblock {
namespace {

struct Threads {
  explicit Threads(int wanted)
      : count(wanted),
        limit(std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                    static_cast<std::size_t>(wanted))),
        arena(std::make_unique<tbb::task_arena>(wanted)) {}

  int count;
  std::unique_ptr<tbb::global_control> limit;
  std::unique_ptr<tbb::task_arena> arena;  ///< has that many, also where there are fewer processors
};

int processors() {
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

Threads& threads() {
  static Threads all(processors());
  return all;
}

}  // namespace

void set_loop_threads(int count) {
  threads() = Threads(count > 0 ? count : processors());
}

int loop_threads() {
  return threads().count;
}

void for_ranges(std::size_t count, const std::function<void(std::size_t, std::size_t, std::size_t)>& work,
                Work weight) {
  const std::size_t ranges = range_count(count);
  const auto one = [&](std::size_t range) {
    work(range, range * kLoopRange, std::min(count, (range + 1) * kLoopRange));
  };
  if (ranges < worth_waking(weight) || loop_threads() == 1) {
    for (std::size_t range = 0; range < ranges; ++range) one(range);
    return;
  }
  std::vector<std::exception_ptr> thrown(ranges);
  threads().arena->execute([&] {
    tbb::parallel_for(
        std::size_t{0}, ranges,
        [&](std::size_t range) {
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
