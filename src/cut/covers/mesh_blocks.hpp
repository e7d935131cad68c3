// Gives covers to selected blocks of a scene: cuts each on a mesh of its own and leaves the others as blocks.
// Theory: docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "cut/bodies/body_graph.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// Place of a block of the scene: block `block` of the rest, or body `body` of the manifold; the other is -1.
struct Whereabouts {
  int block = -1;
  int body = -1;
};

struct MeshedBlocks {
  Blocks rest;  ///< without points and bolts
  Manifold manifold;
  std::vector<Whereabouts> blocks;  ///< per block of the scene
};

/// Cuts each block for which `is_meshed` is true, on the mesh from `mesh_for` and with the cracks from `graph_for`.
MeshedBlocks mesh_blocks(const Blocks& scene, const std::function<bool(const BlockPolygon&)>& is_meshed,
                         const std::function<BodyGraph(const BlockPolygon&)>& graph_for,
                         const std::function<TriangleMesh(const BlockPolygon&, const BodyGraph&)>& mesh_for);

}  // namespace keyblock
