// Sums over contacts by pairs of elements.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/contact_frame.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace keyblock {

std::string_view word_for(ContactCondition condition) {
  switch (condition) {
    case ContactCondition::open:
      return "open";
    case ContactCondition::stick:
      return "stick";
    case ContactCondition::slide:
      return "slide";
  }
  return "";
}

std::vector<JointSum> joint_sums(const ContactFrames& contacts) {
  std::map<std::tuple<int, int, int>, JointSum> sums;
  for (const ContactFrame& contact : contacts) {
    const auto [low, high] = std::minmax(contact.element, contact.other);
    JointSum& sum = sums[{low, high, contact.joint_material}];
    sum.element = low;
    sum.other = high;
    sum.joint_material = contact.joint_material;
    ++sum.contacts;
    sum.closed += contact.condition != ContactCondition::open ? 1 : 0;
    sum.sliding += contact.condition == ContactCondition::slide ? 1 : 0;
    sum.normal_force += contact.normal_force;
    sum.shear_force += contact.shear_force;
    sum.force = sum.force + (contact.element == low ? 1.0 : -1.0) * contact.force();
  }
  std::vector<JointSum> all;
  for (const auto& [key, sum] : sums) all.push_back(sum);
  return all;
}

}  // namespace keyblock
