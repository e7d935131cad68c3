// Builds stages of DDA blocks and NMM bodies: a stage may give blocks a mesh, or another one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/problem.hpp"
#include "run/stages/rock.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Returns true if a case has DDA blocks next to NMM bodies, or a stage that gives blocks a mesh.
bool has_mixed_stages(const Problem& problem);

/// Models of mixed stages. The mesh is that of `covers` until a stage gives another. From then on, a block that a stage
/// cuts or excavates has a mesh of its own shape.
class MixedStages {
 public:
  /// Takes a problem. Throws InputError for excavations of `covers`, and if a stage would mesh bodies that share a
  /// mesh.
  explicit MixedStages(const Problem& problem);

  /// Returns the model at a stage (the first is 0), with the points, bolts and materials of the rock. Throws InputError
  /// as `mixed_model`.
  Model model(const Rock& rock, int stage, const Settings& settings) const;

 private:
  CoverPlan plan_;
  std::vector<MeshPlan> meshes_;  ///< per stage
};

/// Returns, per element of `after`, the element of `before` that it is a part of, or that was cut from the same block.
Table<ElementIndex, ElementIndex> mixed_parents(const Model& before, const Model& after, const Descent& descent);

}  // namespace keyblock
