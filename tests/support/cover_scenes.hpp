// Builds scenes for Dynamics::standard with DDA blocks and NMM bodies.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cut/covers/mesh_blocks.hpp"
#include "cut/mesh/background_mesh.hpp"
#include "model/continuum.hpp"
#include "model/setup/from_manifold.hpp"
#include "model/setup/join.hpp"
#include "tests/support/standard_scenes.hpp"

namespace keyblock::support {

/// Returns a mesh of the given half rows, rotated by 10 degrees, so that nothing is aligned.
inline TriangleMesh turned_mesh(const BodyGraph& graph, int half_rows) {
  Box box;
  for (Point p : graph.nodes) box.add(p);
  RegularMesh mesh = centred_mesh(box, half_rows, MeshShape::equilateral);
  mesh.angle = radians(10);
  return regular_triangles(box, mesh);
}

/// Returns a scene in which the blocks with the numbers `meshed` (from 0) are NMM bodies.
inline Scene mixed_scene_of(const Blocks& blocks, const std::vector<int>& meshed, const Analysis& analysis,
                            const Settings& settings, int half_rows, CoverFunctions functions) {
  int number = 0;
  const auto is_meshed = [&](const BlockPolygon&) { return std::ranges::count(meshed, number++) > 0; };
  MeshedBlocks parts = mesh_blocks(blocks, is_meshed, graph_of, [&](const BlockPolygon&, const BodyGraph& graph) {
    return turned_mesh(graph, half_rows);
  });
  for (const BlockPoint& point : blocks.fixed_points) {
    BlockPoint moved = point;
    moved.block = parts.blocks[static_cast<std::size_t>(point.block)].block;
    if (moved.block >= 0) parts.rest.fixed_points.push_back(moved);
  }
  Model bodies = model_from_manifold(parts.manifold, {}, analysis);
  bodies.continuum = std::make_shared<Continuum>(
      continuum_of(std::move(parts.manifold), analysis.block_materials, settings, functions));
  Model model = joined(model_from_blocks(parts.rest, analysis), bodies);
  return {with_bases(std::move(model), settings.basis), settings};
}

}  // namespace keyblock::support
