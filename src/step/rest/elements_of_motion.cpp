// Copies unknowns, contacts, bonds, bolts and supports of chosen elements from one motion to another.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/elements_of_motion.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace keyblock {

Motion with_elements_of(const StandardScene& scene, const ChosenElements& chosen, const Motion& from, Motion motion) {
  for (const auto& group : scene.groups) group->put_back(chosen, from, motion);
  const auto is_kept = [&](ElementIndex e) { return chosen[static_cast<std::size_t>(e.value)]; };
  const auto is_of_kept = [&](VertexIndex v) { return is_kept(scene.model.vertices[v].element); };
  const auto is_kept_contact = [&](const ClosedContact& contact) {
    return is_of_kept(contact.touch.vertex) || is_of_kept(contact.touch.start);
  };
  std::vector<ClosedContact> closed;
  std::ranges::copy_if(from.closed.all(), std::back_inserter(closed), is_kept_contact);
  std::ranges::remove_copy_if(motion.closed.all(), std::back_inserter(closed), is_kept_contact);
  motion.closed = ClosedContacts(std::move(closed));
  const auto kept_bond = [&](const auto& bond) { return is_of_kept(bond.first.lower) || is_of_kept(bond.first.upper); };
  std::erase_if(motion.bonds, kept_bond);
  for (const auto& bond : from.bonds)
    if (kept_bond(bond)) motion.bonds.insert(bond);
  for (std::size_t i = 0; i < scene.model.bolts.size(); ++i) {
    const Bolt& bolt = scene.model.bolts[i];
    if (!is_kept(bolt.first.element) && !is_kept(bolt.second.element)) continue;
    motion.constraints.bolt_forces[i] = from.constraints.bolt_forces[i];
    motion.constraints.broken[i] = from.constraints.broken[i];
  }
  for (std::size_t i = 0; i < scene.held.size(); ++i) {
    const auto n = static_cast<Eigen::Index>(2 * i);
    if (is_kept(scene.held[i].element))
      motion.constraints.point_forces.segment<2>(n) = from.constraints.point_forces.segment<2>(n);
  }
  return motion;
}

}  // namespace keyblock
