// Stages of blocks some of which are on covers: a stage may give blocks a mesh, or another one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/problem.hpp"
#include "run/stages/rock.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Whether a case has blocks beside bodies on covers, or a stage that gives blocks a mesh.
bool has_mixed_stages(const Problem& problem);

/// The mesh is that of `covers` until a stage gives another; a block that a stage cuts or digs has one of its own shape
/// from there on.
class MixedStages {
 public:
  /// Throws InputError for excavations of `covers`, and where a stage would give a mesh to bodies that share one.
  explicit MixedStages(const Problem& problem);

  /// At a stage (the first is 0), with the points, bolts and materials of the rock. Throws InputError as `mixed_model`.
  Model model(const Rock& rock, int stage, const Settings& settings) const;

 private:
  CoverPlan plan_;
  std::vector<MeshPlan> meshes_;  ///< of every stage
};

/// Of every element of `after`, the one of `before` that it is a part of, or was cut from the same block as.
Table<ElementIndex, ElementIndex> mixed_parents(const Model& before, const Model& after, const Descent& descent);

}  // namespace keyblock
