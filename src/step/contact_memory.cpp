// Sorted once, looked up by halving: by touch, and by facing edges.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/contact_memory.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace keyblock {
namespace {

// Keeps the last of those that are equal; `entries` are sorted, equal ones in the order in which they came.
template <class Entry, class Equal>
void keep_last(std::vector<Entry>& entries, const Equal& equal) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (i + 1 < entries.size() && equal(entries[i], entries[i + 1])) continue;
    if (kept != i) entries[kept] = std::move(entries[i]);
    ++kept;
  }
  entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(kept), entries.end());
}

}  // namespace

ClosedContacts::ClosedContacts(std::vector<ClosedContact> contacts) : by_touch_(std::move(contacts)) {
  std::ranges::stable_sort(by_touch_, {}, &ClosedContact::touch);
  keep_last(by_touch_, [](const ClosedContact& a, const ClosedContact& b) { return a.touch == b.touch; });
  by_touch_.shrink_to_fit();
  for (std::uint32_t i = 0; i < by_touch_.size(); ++i)
    if (by_touch_[i].touch.facing.lower) by_facing_.push_back(i);
  const auto facing = [&](std::uint32_t i) { return by_touch_[i].touch.facing; };
  std::ranges::stable_sort(by_facing_, {}, facing);
  keep_last(by_facing_, [&](std::uint32_t a, std::uint32_t b) { return facing(a) == facing(b); });
  by_facing_.shrink_to_fit();
}

const ContactMemory* ClosedContacts::of(const Touch& touch) const {
  const auto exact = std::ranges::lower_bound(by_touch_, touch, {}, &ClosedContact::touch);
  if (exact != by_touch_.end() && exact->touch == touch) return &exact->memory;
  if (!touch.facing.lower) return nullptr;
  const auto facing = [&](std::uint32_t i) { return by_touch_[i].touch.facing; };
  const auto twin = std::ranges::lower_bound(by_facing_, touch.facing, {}, facing);
  return twin == by_facing_.end() || facing(*twin) != touch.facing ? nullptr : &by_touch_[*twin].memory;
}

std::span<const ClosedContact> ClosedContacts::at(VertexIndex vertex) const {
  return std::ranges::equal_range(by_touch_, vertex, {}, [](const ClosedContact& c) { return c.touch.vertex; });
}

}  // namespace keyblock
