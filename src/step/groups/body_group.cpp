// Finds the group of an element.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/groups/body_group.hpp"

#include <algorithm>

namespace keyblock {

const BodyGroup& BodyGroups::of(ElementIndex e) const {
  return **std::ranges::find_if(groups_, [&](const Group& group) { return group->has(e); });
}

bool BodyGroups::are_one_body(ElementIndex a, ElementIndex b) const {
  const BodyGroup& group = of(a);
  return group.has(b) && group.are_one_body(a, b);
}

}  // namespace keyblock
