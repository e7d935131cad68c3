// Shifts every index of the appended manifold by the counts before it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/covers/join_manifolds.hpp"

namespace keyblock {

void join(Manifold& to, const Manifold& more) {
  const auto count = [](const auto& list) { return static_cast<int>(list.size()); };
  const int bodies = count(to.body_materials), elements = count(to.elements), corners = count(to.corners);
  const int holes = count(to.holes), covers = count(to.covers), cover_elements = count(to.cover_elements);
  const int boundary_edges = count(to.boundary_edges);
  to.body_materials.insert(to.body_materials.end(), more.body_materials.begin(), more.body_materials.end());
  for (ManifoldElement element : more.elements) {
    element.body += bodies;
    for (int& cover : element.covers) cover += covers;
    element.outer.first += corners;
    element.holes.first += holes;
    to.elements.push_back(element);
  }
  for (ElementCorner corner : more.corners) {
    if (corner.neighbour >= 0) corner.neighbour += elements;
    to.corners.push_back(corner);
  }
  for (SlotRange hole : more.holes) to.holes.push_back({hole.first + corners, hole.size});
  for (PhysicalCover cover : more.covers) {
    cover.elements.first += cover_elements;
    to.covers.push_back(cover);
  }
  for (const int element : more.cover_elements) to.cover_elements.push_back(element + elements);
  for (SlotRange loop : more.boundary_loops) to.boundary_loops.push_back({loop.first + boundary_edges, loop.size});
  to.tips.insert(to.tips.end(), more.tips.begin(), more.tips.end());
  for (BoundaryEdge edge : more.boundary_edges)
    to.boundary_edges.push_back({edge.element + elements, edge.corner + corners});
}

}  // namespace keyblock
