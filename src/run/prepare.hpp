// From a problem to a scene ready to step: cut where a drawing was given, choices taken from profile and overrides.
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

/// A scene, what it takes, and how it came about.
struct Prepared {
  Blocks blocks;
  std::optional<CutReport> cut;  ///< of a drawing; absent where blocks were given
  std::vector<Snap> snaps;
  Warnings warnings;
  Requirements requirements;
  Scene scene;
  std::vector<int> joint_lines = {};  ///< as of the cut
};

/// Whether geometry and analysis are there.
bool can_prepare(const Problem& problem);

/// The problem with its mesh by error found; as it is where it has none. Studies of many runs on one mesh find it once.
/// Throws as `prepare`.
MeshByError with_mesh_found(const Problem& problem, const std::string& profile, const std::vector<Override>& overrides);

/// Adds what was done to the mesh, if anything was, to the requirements, and its warnings.
void tell(const MeshByError& found, Prepared& prepared);

/// The scene of a problem with geometry and analysis, its mesh by error found first where it has one. Throws InputError
/// where one of them is missing, lines close no block, or motions do not fit the points, or the case file names an
/// unknown setting or an invalid value; std::invalid_argument for a profile or an override that is none. Settings of a
/// case file count below the overrides.
Prepared prepare(const Problem& problem, const std::string& profile, const std::vector<Override>& overrides);

}  // namespace keyblock
