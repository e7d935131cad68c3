// Blocks of a scene that are given covers: each is cut on a mesh of its own, the others stay blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "cut/bodies/body_graph.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// Where a block of the scene went: it is block `block` of the rest, or body `body` of the manifold; the other is -1.
struct Whereabouts {
  int block = -1;
  int body = -1;
};

struct MeshedBlocks {
  Blocks rest;  ///< without points and bolts
  Manifold manifold;
  std::vector<Whereabouts> blocks;  ///< of each block of the scene
};

/// Cuts each block that `is_meshed` says of, with the cracks that `graph_for` puts into it, on the mesh that `mesh_for`
/// makes for it.
MeshedBlocks mesh_blocks(const Blocks& scene, const std::function<bool(const BlockPolygon&)>& is_meshed,
                         const std::function<BodyGraph(const BlockPolygon&)>& graph_for,
                         const std::function<TriangleMesh(const BlockPolygon&, const BodyGraph&)>& mesh_for);

}  // namespace keyblock
