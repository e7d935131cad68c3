// Room for long lists in large pages: of a hundred megabytes in small ones, a third of the time goes into page faults.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace keyblock {

/// Asks the system to back that room, not yet touched, by large pages where it is long enough. Never fails: it is
/// advice.
void advise_large_pages(void* room, std::size_t bytes);

/// `list.reserve(count)` in large pages.
template <typename List>
void reserve_large(List& list, std::size_t count) {
  list.reserve(count);
  advise_large_pages(list.data(), list.capacity() * sizeof(*list.data()));
}

}  // namespace keyblock
