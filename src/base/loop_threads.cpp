// Sets the limit of TBB once for all computations.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/loop_threads.hpp"

#include <tbb/global_control.h>

#include <algorithm>
#include <thread>

namespace keyblock {
namespace {

// Limit above any request of a computation. TBB uses the least limit that anyone sets, so it is set once for all;
// without it a context would have no more threads than there are processors.
constexpr std::size_t kThreadLimit = 256;

}  // namespace

std::shared_ptr<LoopThreads> loop_threads_of(int count) {
  static const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, kThreadLimit);
  // One arena for all contexts that set no number: several at once share the processors.
  static const auto usual =
      std::make_shared<LoopThreads>(static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
  return count > 0 ? std::make_shared<LoopThreads>(count) : usual;
}

}  // namespace keyblock
