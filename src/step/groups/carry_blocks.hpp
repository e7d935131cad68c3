// Displacement, velocity and memory of blocks, carried over to what is left of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "step/groups/body_group.hpp"

namespace keyblock {

/// The outline and holes of an element at the start.
std::vector<std::vector<Point>> loops_of(const Model& model, ElementIndex e);

/// A block cut from a block: the affine field of that about the centroid of its piece; its velocity as the mass of the
/// block has it, whose points lie where they would without strain: kinetic energy is kept to round-off.
void carry_block(const SceneParts& scene, ElementIndex e, const BodiesBefore& before, BodiesMotion& carried);

/// A block cut from another body: the affine field nearest to that of the mass. Its mean, and the least squares of what
/// differs from it, keep momentum and angular momentum.
void carry_field(const SceneParts& scene, ElementIndex e, const std::vector<FieldPoint>& field, BodiesMotion& carried);

/// The mean over the block of what the rock remembered; its elastic strain is what the strain at hand leaves.
YieldState carried_memory(ElementIndex old, const std::vector<FieldPoint>& field, const BodiesBefore& before);

}  // namespace keyblock
