// Builds stages of NMM bodies on one mesh; each stage has the part not excavated so far.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/model.hpp"
#include "run/bodies/planned_bodies.hpp"
#include "run/stages/rock.hpp"
#include "settings/settings.hpp"

namespace keyblock {

class CoverStages {
 public:
  /// Takes a problem. Throws InputError for a cover file, for DDA blocks next to NMM bodies, and for a stage that cuts
  /// lines.
  explicit CoverStages(const Problem& problem);

  /// Returns the bodies as blocks, which hold points and bolts from stage to stage.
  const Blocks& bodies() const { return planned_.blocks(); }

  /// Returns the model at a stage (the first is 0), with the points, bolts and materials of the rock. Chains of
  /// tractions and displacements that are excavated by then have no effect. Throws InputError as `cover_model`.
  Model model(const Rock& rock, int stage, const Settings& settings) const;

 private:
  int joint_material_at(int stage, int first) const;
  Continuum continuum_at(Manifold manifold, const Rock& rock, int stage, const Settings& settings) const;

  Problem problem_;                 ///< with the excavations of the stages in its plan
  std::vector<int> dug_materials_;  ///< joint materials of those excavations
  PlannedBodies planned_;
};

/// Returns, per NMM element of `after`, its parent in `before`: both are cut from one mesh.
Table<ElementIndex, ElementIndex> cover_parents(const Model& before, const Model& after);

}  // namespace keyblock
