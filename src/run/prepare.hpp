// Prepares a scene from a problem: cuts a drawing and takes choices from profile and overrides.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cut/bodies/cut_blocks.hpp"
#include "model/scene/scene.hpp"
#include "model/setup/requirements.hpp"
#include "problem/problem.hpp"
#include "run/mesh/mesh_by_error.hpp"
#include "run/settings_of.hpp"

namespace keyblock {

/// Scene ready to run, the solver features it needs, and a record of how it was built.
struct Prepared {
  Blocks blocks;
  std::optional<CutReport> cut;  ///< of a drawing; empty if blocks were given
  std::vector<Snap> snaps;
  Warnings warnings;
  Requirements requirements;
  Scene scene;
  std::vector<int> joint_lines = {};  ///< as of the cut
};

/// Returns true if geometry and analysis exist.
bool can_prepare(const Problem& problem);

/// Returns the problem with its mesh by error found, or unchanged without one. Studies of many runs on one mesh find it
/// once. Throws as `prepare`.
MeshByError with_mesh_found(const Problem& problem, const std::string& profile, const std::vector<Override>& overrides);

/// Adds the record of mesh refinement, and its warnings, to `prepared`.
void tell(const MeshByError& found, Prepared& prepared);

/// Returns the scene of a problem with geometry and analysis. A mesh by error is found first. Throws InputError if one
/// of them is missing, lines close no block, or motions do not fit the points. Throws it also for an unknown or invalid
/// setting of the case file, and std::invalid_argument for an invalid profile or override. Overrides replace settings
/// of the case file.
Prepared prepare(const Problem& problem, const std::string& profile, const std::vector<Override>& overrides);

}  // namespace keyblock
