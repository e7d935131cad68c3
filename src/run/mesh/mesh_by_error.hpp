// The mesh of bodies on covers halved where the stresses are least certain, until they are as good as was asked.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/scene/scene.hpp"
#include "problem/problem.hpp"
#include "settings/settings_table.hpp"

namespace keyblock {

/// One mesh that was tried.
struct MeshRound {
  int elements = 0;
  int unknowns = 0;
  double error = 0;  ///< estimated, of the energy norm
};

struct MeshByError {
  Problem problem;                ///< whose mesh is refined at points and has no error to reach
  std::vector<MeshRound> rounds;  ///< the last one is of this mesh; none where the case asks for no error
  Warnings warnings;              ///< `mesh_error_not_reached`, `mesh_error_at_points`

  /// Half a sentence: what was done to the mesh; empty where nothing was asked.
  std::string sentence() const;
};

/// Whether the case asks for a mesh by error.
bool has_mesh_by_error(const Problem& problem);

/// The bodies are solved as linear elastic rock at rest under the loads of the file, all at once, what is ever dug out
/// gone and nothing touching, whatever the case does with them afterwards. Elements that carry half of the estimated
/// ‖e‖² are halved (Dörfler 1996), as many as have the same error with them, until the share of the energy norm
/// (`stress_error`) is at most that of `mesh.error` and the last round changed the energy by no more than estimated; a
/// first mesh that is fine enough stays if one with all triangles halved agrees. Within a quarter of the first mesh's
/// side about a point that bears a force, where the stress has no limit, errors do not count. `scene` makes a problem a
/// scene under overrides of its own. Throws InputError where bodies are not held so that there is a solution, or the
/// first mesh has more than `mesh.most_unknowns`.
MeshByError mesh_by_error(const Problem& problem,
                          const std::function<Scene(const Problem&, const std::vector<Override>&)>& scene);

}  // namespace keyblock
