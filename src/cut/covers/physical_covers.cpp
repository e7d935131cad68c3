// Connects stars across sides of the mesh; see physical_covers.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/covers/physical_covers.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

#include "base/union_find.hpp"

namespace keyblock {
namespace {

/// One of the three nodes of an element's triangle; its number is 3 · element + place.
struct Slot {
  int node = 0;
  int group = 0;  ///< lowest slot of the cover
  int slot = 0;
};

/// Joins the slots of the two nodes of the side that both triangles share. (If cutting left out a face without
/// thickness, an edge of round-off length may lead back into the same triangle.)
void join(const Manifold& manifold, int a, int b, UnionFind& groups) {
  if (manifold.elements[a].triangle == manifold.elements[b].triangle) return;
  const auto& of_a = manifold.mesh.triangles[manifold.elements[a].triangle];
  const auto& of_b = manifold.mesh.triangles[manifold.elements[b].triangle];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (of_a[i] == of_b[j]) groups.unite(3 * a + i, 3 * b + j);
    }
  }
}

/// Lists the covers in the order of (node, group), and the elements of each.
void list_covers(std::vector<Slot> slots, Manifold& manifold) {
  std::sort(slots.begin(), slots.end(), [](const Slot& a, const Slot& b) {
    return std::tie(a.node, a.group, a.slot) < std::tie(b.node, b.group, b.slot);
  });
  manifold.covers.clear();
  manifold.cover_elements.clear();
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const bool is_new = k == 0 || slots[k - 1].node != slots[k].node || slots[k - 1].group != slots[k].group;
    if (is_new) manifold.covers.push_back({slots[k].node, {static_cast<int>(k), 0}});
    ++manifold.covers.back().elements.size;
    manifold.elements[slots[k].slot / 3].covers[slots[k].slot % 3] = static_cast<int>(manifold.covers.size()) - 1;
    manifold.cover_elements.push_back(slots[k].slot / 3);
  }
}

template <class Group>
void list_by(Manifold& manifold, Group group) {
  std::vector<Slot> slots;
  slots.reserve(3 * manifold.elements.size());
  for (int s = 0; s < static_cast<int>(3 * manifold.elements.size()); ++s) {
    slots.push_back({manifold.mesh.triangles[manifold.elements[s / 3].triangle][s % 3], group(s), s});
  }
  list_covers(std::move(slots), manifold);
}

}  // namespace

void set_covers(Manifold& manifold) {
  UnionFind groups(3 * manifold.elements.size());
  const auto join_neighbours = [&](int element, const SlotRange& range) {
    for (const ElementCorner& corner : manifold.loop(range)) {
      if (corner.neighbour > element) join(manifold, element, corner.neighbour, groups);
    }
  };
  for (std::size_t e = 0; e < manifold.elements.size(); ++e) {
    const ManifoldElement& element = manifold.elements[e];
    join_neighbours(static_cast<int>(e), element.outer);
    for (const SlotRange& hole : manifold.holes_of(element)) join_neighbours(static_cast<int>(e), hole);
  }
  list_by(manifold, [&](int slot) { return groups.find(slot); });
}

void relist_covers(Manifold& manifold) {
  std::vector<int> before;
  for (const ManifoldElement& element : manifold.elements)
    before.insert(before.end(), element.covers.begin(), element.covers.end());
  list_by(manifold, [&](int slot) { return before[slot]; });
}

}  // namespace keyblock
