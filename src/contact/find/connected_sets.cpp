// Unites the elements of each pair, then marks the sets that are held; see connected_sets.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/find/connected_sets.hpp"

#include "base/union_find.hpp"

namespace keyblock {

ConnectedSets::ConnectedSets(const Model& model, std::vector<ElementPair> pairs,
                             const std::vector<ElementIndex>& supported)
    : is_held_(model.elements.size()) {
  const auto can_move = [&](ElementIndex e) { return model.elements[e].can_move(); };
  for (const Bolt& bolt : model.bolts) pairs.push_back({bolt.first.element, bolt.second.element});
  UnionFind groups(model.elements.size());
  for (const auto& [a, b] : pairs)
    if (can_move(a) && can_move(b)) groups.unite(a.value, b.value);
  for (const ElementIndex e : indices(model.elements)) {
    numbers_.push_back(static_cast<std::size_t>(groups.find(e.value)));
    if (!can_move(e)) is_held_[numbers_.back()] = true;
  }
  for (const auto& [a, b] : pairs)
    if (!can_move(a) || !can_move(b)) is_held_[of(a)] = is_held_[of(b)] = true;
  for (const ElementIndex e : supported) is_held_[of(e)] = true;
}

std::vector<ElementPair> pairs_of(const Model& model, const Touches& touches) {
  std::vector<ElementPair> pairs;
  for (const Touch& touch : touches)
    pairs.push_back({model.vertices[touch.vertex].element, model.vertices[touch.start].element});
  return pairs;
}

}  // namespace keyblock
