// Reserves memory of long lists in large pages. With small pages, a third of the time for a hundred megabytes is spent
// on page faults.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace keyblock {

/// Advises the system to back this untouched memory by large pages, if it is long enough. Never fails.
void advise_large_pages(void* room, std::size_t bytes);

/// Calls `list.reserve(count)` with large pages.
template <typename List>
void reserve_large(List& list, std::size_t count) {
  list.reserve(count);
  advise_large_pages(list.data(), list.capacity() * sizeof(*list.data()));
}

}  // namespace keyblock
