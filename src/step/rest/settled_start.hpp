// Computes the initial equilibrium of a jointed rock mass. Rigid-body statics leaves its contact forces undetermined;
// the elasticity of blocks and contacts decides them. Theory: docs/theory/07-initial-state-and-statics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// Initial equilibrium of blocks that hold each other in rings. All touching faces are glued and loaded in one static
/// step, unless contacts have the forces of the initial stress. Iterations of statics then release the faces. Where no
/// equilibrium lies near by, the blocks begin where they were drawn, or where they began to move, under forces that
/// have settled as far as they do. Blocks not connected to a support stay unloaded. Velocities are those of `motion`.
struct Settled {
  Motion motion;
  int unsolved_steps = 0;  ///< steps without forces, which changed nothing
  double left = 0;         ///< if all steps were used: motion of the last one, over that of a body without contacts
};
Settled settled(const StandardScene& scene, Motion motion);

}  // namespace keyblock
