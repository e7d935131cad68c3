// Manifolds one after another, with all their numbers moved on.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/mesh_blocks.hpp"

#include "cut/cut_cover.hpp"

namespace keyblock {
namespace {

template <class List>
int size_of(const List& list) {
  return static_cast<int>(list.size());
}

SlotRange moved_on(SlotRange range, int by) {
  return {range.first + by, range.size};
}

}  // namespace

MeshedBlocks mesh_blocks(const Blocks& scene, const std::function<bool(const BlockPolygon&)>& is_meshed,
                         const std::function<TriangleMesh(const BodyGraph&)>& mesh_for) {
  MeshedBlocks result;
  result.rest.place = scene.place;
  for (const BlockPolygon& block : scene.blocks) {
    if (!is_meshed(block)) {
      result.blocks.push_back({size_of(result.rest.blocks), -1});
      result.rest.blocks.push_back(block);
      continue;
    }
    const BodyGraph graph = graph_of(block);
    result.blocks.push_back({-1, size_of(result.manifold.body_materials)});
    append(result.manifold, cut_cover(graph, mesh_for(graph)));
  }
  return result;
}

void append(Manifold& manifold, const Manifold& more) {
  const int nodes = size_of(manifold.mesh.nodes);
  const int triangles = size_of(manifold.mesh.triangles);
  const int bodies = size_of(manifold.body_materials);
  const int elements = size_of(manifold.elements);
  const int corners = size_of(manifold.corners);
  const int holes = size_of(manifold.holes);
  const int covers = size_of(manifold.covers);
  const int cover_elements = size_of(manifold.cover_elements);
  const int boundary_edges = size_of(manifold.boundary_edges);
  const auto add_all = [](auto& list, const auto& others) { list.insert(list.end(), others.begin(), others.end()); };
  add_all(manifold.mesh.nodes, more.mesh.nodes);
  add_all(manifold.body_materials, more.body_materials);
  for (std::array<int, 3> triangle : more.mesh.triangles) {
    for (int& node : triangle) node += nodes;
    manifold.mesh.triangles.push_back(triangle);
  }
  for (ManifoldElement element : more.elements) {
    element.triangle += triangles;
    element.body += bodies;
    for (int& cover : element.covers) cover += covers;
    element.outer = moved_on(element.outer, corners);
    element.holes = moved_on(element.holes, holes);
    manifold.elements.push_back(element);
  }
  for (ElementCorner corner : more.corners) {
    if (corner.neighbour >= 0) corner.neighbour += elements;
    manifold.corners.push_back(corner);
  }
  for (const SlotRange& hole : more.holes) manifold.holes.push_back(moved_on(hole, corners));
  for (const PhysicalCover& cover : more.covers)
    manifold.covers.push_back({cover.node + nodes, moved_on(cover.elements, cover_elements)});
  for (const int element : more.cover_elements) manifold.cover_elements.push_back(element + elements);
  for (const SlotRange& loop : more.boundary_loops) manifold.boundary_loops.push_back(moved_on(loop, boundary_edges));
  for (const BoundaryEdge& edge : more.boundary_edges)
    manifold.boundary_edges.push_back({edge.element + elements, edge.corner + corners});
}

}  // namespace keyblock
