// A motion carried over into the scene that follows: what stays keeps its place, velocity, strain and contact forces.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scene/scene_map.hpp"
#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// The model of the later scene with what only the motion knows: points that are held in place are held where they are
/// now, and bolts that are new have their pretension at their present length.
Model installed(Model model, const SceneMap& map, const StandardScene& before, const Motion& motion);

/// A piece of a block moves as the block did there: place, velocity, turn and strain are those of the affine field of
/// the block, so that momentum and angular momentum of all that stays are kept. Contacts, bonds, bolts and held points
/// keep their forces where both sides and the edge are still there. Faces whose joint material is another now are
/// bonded where that has strength and they touch, and no more where it has none. Accelerations are left at zero.
Motion carried_motion(const StandardScene& before, const Motion& motion, const SceneMap& map,
                      const StandardScene& after, double time);

}  // namespace keyblock
