// Stages of bodies on covers: one mesh for all of them, of which each stage has what is not dug out by then.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/model.hpp"
#include "run/bodies/planned_bodies.hpp"
#include "run/stages/rock.hpp"
#include "settings/settings.hpp"

namespace keyblock {

class CoverStages {
 public:
  /// Throws InputError for a cover file, for blocks beside bodies on covers, and for a stage that cuts lines.
  explicit CoverStages(const Problem& problem);

  /// The bodies as blocks, which carry points and bolts from stage to stage.
  const Blocks& bodies() const { return planned_.blocks(); }

  /// At a stage (the first is 0), with the points, bolts and materials of the rock. Chains of tractions and
  /// displacements that a stage leaves nothing of are without effect there. Throws InputError as `cover_model`.
  Model model(const Rock& rock, int stage, const Settings& settings) const;

 private:
  int joint_material_at(int stage, int first) const;
  Continuum continuum_at(Manifold manifold, const Rock& rock, const Settings& settings) const;

  Problem problem_;                 ///< with what the stages dig out as excavations of its plan
  std::vector<int> dug_materials_;  ///< joint materials of those excavations
  PlannedBodies planned_;
};

/// Of every element on covers of `after`, the one of `before` that it is a part of: both are cut from one mesh.
Table<ElementIndex, ElementIndex> cover_parents(const Model& before, const Model& after);

}  // namespace keyblock
