// Divides a scene into lots: blocks that statics and the initial state solve for together, apart from the others.
// Theory: docs/theory/07-initial-state-and-statics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "step/rest/static_shares.hpp"
#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// Returns the movable elements of each lot: connected sets whose largest loads at `time`, or forces of initial stress,
/// are within kAlikeForces of each other. One lot per set would cost a scene with hundreds of sets as many starts.
/// Empty if there is one lot, and for scenes with NMM bodies or blocks that may yield.
std::vector<ChosenElements> lots_of(const StandardScene& scene, const Motion& motion, double time);

/// Returns true if elements of two lots are in reach of each other in this motion, at rest.
bool one_meets_another(const StandardScene& scene, const std::vector<ChosenElements>& lots, const Motion& motion);

/// Scene with the movable elements of one lot alone. The others keep their numbers, but have neither unknowns nor
/// faces.
class Lot {
 public:
  /// Keeps a reference to `whole`.
  Lot(const StandardScene& whole, ChosenElements chosen);

  const StandardScene& scene() const { return scene_; }
  StandardScene& scene() { return scene_; }

  /// Returns the part of a motion of the whole scene.
  Motion part_of(const Motion& all) const;
  /// Puts a motion of the lot into one of the whole scene.
  void put(const Motion& own, Motion& all) const;

 private:
  /// Returns true if a vertex of the two belongs to the lot.
  bool is_own(VertexIndex one, VertexIndex other) const;
  /// Copies what belongs to the lot, but no constraints.
  void copy(const Motion& from, Motion& to) const;

  const StandardScene& whole_;
  ChosenElements chosen_;
  StandardScene scene_;
  std::vector<std::size_t> bolts_;  ///< of the lot, in the whole scene
  std::vector<std::size_t> held_;   ///< of the lot, in the whole scene
};

/// Makes the load step of each lot by itself (`static_equilibrium`), or of the whole scene if lots meet. Where a lot
/// has no equilibrium, the whole scene names all blocks that move.
StandardStep equilibrium_of_lots(StandardScene& scene, const Motion& motion, const LoadStep& step);

}  // namespace keyblock
