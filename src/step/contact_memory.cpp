// Two maps to the same memories: by touch, and by facing edges.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/contact_memory.hpp"

namespace keyblock {

void ClosedContacts::add(const Touch& touch, const ContactMemory& memory) {
  by_touch_[touch] = memory;
  if (touch.facing.lower) by_facing_[touch.facing] = memory;
}

const ContactMemory* ClosedContacts::of(const Touch& touch) const {
  if (const auto exact = by_touch_.find(touch); exact != by_touch_.end()) return &exact->second;
  if (!touch.facing.lower) return nullptr;
  const auto twin = by_facing_.find(touch.facing);
  return twin == by_facing_.end() ? nullptr : &twin->second;
}

}  // namespace keyblock
