// Transfers a motion into the next scene: remaining bodies keep place, velocity, strain and contact forces.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scene/scene_map.hpp"
#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// Returns the model of the later scene, completed from the motion. Points that hold in place are fixed at their
/// current position. New bolts have their pretension at their current length.
Model installed(Model model, const SceneMap& map, const StandardScene& before, const Motion& motion);

/// Returns the motion in the later scene. A piece of a block follows the affine field of that block in place, velocity,
/// rotation and strain. This conserves the momentum and angular momentum of all that remains. Contacts, bonds, bolts
/// and fixed points keep their forces if both sides and the edge remain. Touching faces with a changed joint material
/// are bonded if that has strength, and lose their bond otherwise. Accelerations are zero.
Motion carried_motion(const StandardScene& before, const Motion& motion, const SceneMap& map,
                      const StandardScene& after, double time);

}  // namespace keyblock
