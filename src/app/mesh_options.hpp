// The options that ask for a mathematical mesh, and the mesh that they ask for.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <vector>

#include "cut/background_mesh.hpp"
#include "cut/body_graph.hpp"
#include "cut/unstructured_mesh.hpp"

namespace keyblock {

enum class MeshPlacement {
  free,     ///< wherever the mesh comes to stand
  aligned,  ///< rows on the lower and the upper edge; unstructured: sides along all lines
};

/// A regular mesh has `half_rows`, an unstructured one `side`; with neither there is none.
struct MeshOptions {
  int half_rows = 0;
  MeshShape shape = MeshShape::equilateral;
  double angle_deg = 0;
  double side = 0;
  std::vector<double> refined;  ///< x, y, side of each point in turn
  MeshPlacement placement = MeshPlacement::free;
  double snap_ratio = 0;  ///< over the scale of the mesh
};

void add_mesh_options(CLI::App& app, MeshOptions& options);

/// Throws UsageError where options of a mesh stand without one.
bool is_asked_for(const MeshOptions& options);

struct FittedMesh {
  TriangleMesh mesh;
  int snapped = 0;  ///< nodes moved onto lines
};

/// The mesh over all bodies. Throws UsageError where it would be too large.
FittedMesh fitted_mesh(const MeshOptions& options, const BodyGraph& graph);

}  // namespace keyblock
