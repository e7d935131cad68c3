// The only file that sees the library of threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/loop.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <thread>

namespace keyblock {
namespace {

// Fewer ranges than this are done by the caller alone: waking threads would take as long.
constexpr std::size_t kWorthWaking = 4;

struct Threads {
  int count = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::unique_ptr<tbb::global_control> limit;
};

Threads& threads() {
  static Threads one;
  return one;
}

}  // namespace

void set_loop_threads(int count) {
  Threads& all = threads();
  all = {};
  if (count <= 0) return;
  all.count = count;
  all.limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                    static_cast<std::size_t>(count));
}

int loop_threads() {
  return threads().count;
}

void for_ranges(std::size_t count, const std::function<void(std::size_t, std::size_t, std::size_t)>& work) {
  const std::size_t ranges = range_count(count);
  const auto one = [&](std::size_t range) {
    work(range, range * kLoopRange, std::min(count, (range + 1) * kLoopRange));
  };
  if (ranges < kWorthWaking || loop_threads() == 1) {
    for (std::size_t range = 0; range < ranges; ++range) one(range);
    return;
  }
  tbb::parallel_for(std::size_t{0}, ranges, one, tbb::static_partitioner());
}

}  // namespace keyblock
