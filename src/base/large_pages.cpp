// Uses transparent huge pages of Linux; does nothing on other systems.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/large_pages.hpp"

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstdint>

namespace keyblock {
namespace {

constexpr std::uintptr_t kLargePage = 2 << 20;  // of x86-64, and the usual one of ARM

}  // namespace

void advise_large_pages(void* room, std::size_t bytes) {
#ifdef __linux__
  const auto begin = reinterpret_cast<std::uintptr_t>(room);
  const std::uintptr_t first = (begin + kLargePage - 1) / kLargePage * kLargePage;
  const std::uintptr_t last = (begin + bytes) / kLargePage * kLargePage;
  if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#else
  static_cast<void>(room), static_cast<void>(bytes);
#endif
}

}  // namespace keyblock
