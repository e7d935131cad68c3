// A start at rest under the first loads, of what something bears.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "step/scene/standard_scene.hpp"

namespace keyblock {

struct RestingStart {
  Motion motion;           ///< velocities as at the start
  bool is_found = false;   ///< of some bodies
  int sudden = 0;          ///< bodies without: they move, nothing holds them, or they have no equilibrium
  std::string unbalanced;  ///< which bodies were sought an equilibrium of and have none, and why; empty where all have
};

/// The static equilibrium (`first_equilibrium`) of bodies under the loads of t = 0: displacements, stresses, and
/// contact forces with their memories. It is sought of bodies that hang together, by touching or by bolts, with
/// something that is held, where none of them has a velocity; the others, as a body in flight, bear no load meanwhile
/// and stay as they are in `start`. So do those that hang together with a body that falls, slides or finds no rest,
/// and those whose equilibrium is another place than where they were drawn, as that of a pendulum, or of a block that
/// slides against a wall.
RestingStart resting_start(StandardScene scene, const Motion& start);

}  // namespace keyblock
