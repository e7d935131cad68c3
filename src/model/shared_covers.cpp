// Finds bodies by union of the elements of each cover.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shared_covers.hpp"

#include "base/union_find.hpp"

namespace keyblock {

std::vector<bool> carrying_nodes(const Model& model) {
  std::vector<bool> carry(model.nodes.size(), false);
  for (const Element& element : model.elements) {
    if (!element.is_on_covers()) continue;
    for (const int node : element.covers) carry[static_cast<std::size_t>(node)] = true;
  }
  return carry;
}

std::vector<int> body_numbers(const Model& model) {
  std::vector<int> first_of_cover;  // the first element on it, or -1
  UnionFind groups(model.elements.size());
  for (ElementIndex e : indices(model.elements)) {
    for (const int cover : model.elements[e].covers) {
      const auto c = static_cast<std::size_t>(cover);
      if (c >= first_of_cover.size()) first_of_cover.resize(c + 1, -1);
      if (first_of_cover[c] < 0) first_of_cover[c] = e.value;
      groups.unite(first_of_cover[c], e.value);
    }
  }
  std::vector<int> bodies;
  int count = 0;
  for (ElementIndex e : indices(model.elements)) {
    const int lowest = groups.find(e.value);
    bodies.push_back(lowest == e.value ? count++ : bodies[static_cast<std::size_t>(lowest)]);
  }
  return bodies;
}

}  // namespace keyblock
