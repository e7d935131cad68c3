// Refines the mesh of NMM bodies where stresses are least accurate, until they reach the requested accuracy. Theory:
// docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/scene/scene.hpp"
#include "problem/problem.hpp"
#include "settings/settings_table.hpp"

namespace keyblock {

/// Mesh that was tried.
struct MeshRound {
  int elements = 0;
  int unknowns = 0;
  double error = 0;  ///< estimated, of the energy norm
};

struct MeshByError {
  Problem problem;                ///< its mesh is refined at points and has no target error
  std::vector<MeshRound> rounds;  ///< the last one is of this mesh; empty if the case sets no target error
  Warnings warnings;              ///< `mesh_error_not_reached`, `mesh_error_at_points`

  /// Describes the refinement in half a sentence; empty if none was requested.
  std::string sentence() const;
};

/// Returns true if the case requests a mesh by error.
bool has_mesh_by_error(const Problem& problem);

/// Refines the mesh. The bodies are solved as linear elastic rock in statics under all loads of the file, without
/// contact and without anything that is ever excavated. Elements with half of the estimated ‖e‖² are halved (Dörfler
/// 1996), with all of equal error. Refinement ends if the relative error (`stress_error`) is at most `mesh.error`. In
/// addition, the last round must not change the energy by more than estimated. A fine first mesh stays if one with all
/// triangles halved agrees. Stress has no limit at point forces: errors within a quarter of the first mesh's side of
/// one do not count. `scene` makes a scene of a problem under its own overrides. Throws InputError if supports do not
/// suffice, or if the first mesh has more than `mesh.most_unknowns`.
MeshByError mesh_by_error(const Problem& problem,
                          const std::function<Scene(const Problem&, const std::vector<Override>&)>& scene);

}  // namespace keyblock
