// Adds the options that request a mathematical mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <vector>

#include "cut/mesh/fit_mesh.hpp"

namespace keyblock {

struct MeshOptions {
  MeshPlan plan;
  std::vector<double> refined;  ///< x, y, side of each point in turn
};

void add_mesh_options(CLI::App& app, MeshOptions& options);

/// Throws UsageError if options of a mesh are given without one.
bool is_asked_for(const MeshOptions& options);

/// Returns the mesh over all bodies. Throws UsageError if it is impossible or too large.
FittedMesh mesh_asked_for(const MeshOptions& options, const BodyGraph& graph);

}  // namespace keyblock
