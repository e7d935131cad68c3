// Computes the static equilibrium from which supported bodies start a dynamic run. Theory:
// docs/theory/07-initial-state-and-statics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "step/scene/standard_scene.hpp"

namespace keyblock {

struct RestingStart {
  Motion motion;           ///< velocities as at the start
  bool is_found = false;   ///< true if some bodies have an equilibrium
  int moving = 0;          ///< bodies without one that have the strains of their first accelerations
  int sudden = 0;          ///< all other bodies
  std::string unbalanced;  ///< bodies whose search found no equilibrium, and the reason; empty if all have one
};

/// Finds the static equilibrium (`first_equilibrium`) under the loads of t = 0: displacements, stresses, contact forces
/// and their memories. The search covers connected sets, by contact or bolts, that have a support and no initial
/// velocity. All others, such as a body in flight, carry no load meanwhile. The same holds for sets with a body that
/// falls, slides or finds no equilibrium. It also holds if the equilibrium is far from the drawn position, as for a
/// pendulum or a block that slides against a wall. Of these sets, those with a support then take their `moving_start`;
/// the rest stay as in `start`.
RestingStart resting_start(StandardScene scene, const Motion& start);

}  // namespace keyblock
