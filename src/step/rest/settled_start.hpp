// A start of jointed masses, in which contact forces follow from the elasticity of blocks and contacts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// In a mass of blocks that hold each other in rings, equilibrium of rigid blocks leaves contact forces open: they
/// follow from elasticity. First all touching faces are glued and the loads put on in one static step; then the glue is
/// dissolved in a few steps so short that nothing moves by more than the contacts give, each from rest. Blocks that
/// hang together with no block that is fixed or held somewhere are left unloaded. Velocities are those of `motion`.
struct Settled {
  Motion motion;
  int unsolved_steps = 0;  ///< that found no forces and changed nothing
};
Settled settled(const StandardScene& scene, Motion motion);

}  // namespace keyblock
