// Cuts one manifold per block and appends it to the others.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/covers/mesh_blocks.hpp"

#include "cut/covers/cut_cover.hpp"
#include "cut/covers/join_manifolds.hpp"

namespace keyblock {
namespace {

// Appends a manifold that has its own mesh.
void add(Manifold& manifold, Manifold more) {
  const auto nodes = static_cast<int>(manifold.mesh.nodes.size());
  const auto triangles = static_cast<int>(manifold.mesh.triangles.size());
  manifold.mesh.nodes.insert(manifold.mesh.nodes.end(), more.mesh.nodes.begin(), more.mesh.nodes.end());
  for (std::array<int, 3> triangle : more.mesh.triangles) {
    for (int& node : triangle) node += nodes;
    manifold.mesh.triangles.push_back(triangle);
  }
  for (ManifoldElement& element : more.elements) element.triangle += triangles;
  for (PhysicalCover& cover : more.covers) cover.node += nodes;
  join(manifold, more);
}

}  // namespace

MeshedBlocks mesh_blocks(const Blocks& scene, const std::function<bool(const BlockPolygon&)>& is_meshed,
                         const std::function<BodyGraph(const BlockPolygon&)>& graph_for,
                         const std::function<TriangleMesh(const BlockPolygon&, const BodyGraph&)>& mesh_for) {
  MeshedBlocks result;
  result.rest.place = scene.place;
  for (const BlockPolygon& block : scene.blocks) {
    if (!is_meshed(block)) {
      result.blocks.push_back({static_cast<int>(result.rest.blocks.size()), -1});
      result.rest.blocks.push_back(block);
      continue;
    }
    const BodyGraph graph = graph_for(block);
    result.blocks.push_back({-1, static_cast<int>(result.manifold.body_materials.size())});
    add(result.manifold, cut_cover(graph, mesh_for(block, graph)));
  }
  return result;
}

}  // namespace keyblock
