// Sums contacts by pairs of elements.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/contact_frame.hpp"

#include <algorithm>
#include <cmath>
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

std::vector<JointLineSum> joint_line_sums(const ContactFrames& contacts) {
  std::map<int, JointLineSum> sums;
  for (const ContactFrame& contact : contacts) {
    if (contact.joint_line < 0) continue;
    const auto [at, is_new] = sums.try_emplace(contact.joint_line);
    JointLineSum& sum = at->second;
    if (is_new) sum.joint_material = contact.joint_material;
    sum.joint_line = contact.joint_line;
    ++sum.contacts;
    sum.closed += contact.condition != ContactCondition::open ? 1 : 0;
    sum.sliding += contact.condition == ContactCondition::slide ? 1 : 0;
    sum.normal_force += contact.normal_force;
    sum.shear_force += contact.shear_force;
    sum.greatest_gap = std::max(sum.greatest_gap, contact.gap);
    if (std::abs(contact.slip) > std::abs(sum.greatest_slip)) sum.greatest_slip = contact.slip;
  }
  std::vector<JointLineSum> all;
  for (const auto& [line, sum] : sums) all.push_back(sum);
  return all;
}

}  // namespace keyblock
