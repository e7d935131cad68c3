// Options of the C library of Linux; elsewhere nothing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/heap.hpp"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace keyblock {
namespace {

constexpr int kLargest =
    32 << 20;                   // the most that the library takes; larger pieces are given back at once all the same
constexpr int kKept = 1 << 30;  // bytes

}  // namespace

void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, kLargest);
  mallopt(M_TRIM_THRESHOLD, kKept);
#else
  static_cast<void>(kLargest), static_cast<void>(kKept);
#endif
}

}  // namespace keyblock
