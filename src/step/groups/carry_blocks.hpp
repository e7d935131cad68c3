// Transfers displacement, velocity and memory of blocks to their remaining pieces.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "step/groups/body_group.hpp"

namespace keyblock {

/// Returns the outline and holes of an element in its initial position.
std::vector<std::vector<Point>> loops_of(const Model& model, ElementIndex e);

/// Transfers the state of a block to a block cut from it: the same affine field about the centroid of the piece. The
/// velocity is that of the block's mass, whose points lie where they would without strain. This keeps kinetic energy to
/// round-off.
void carry_block(const SceneParts& scene, ElementIndex e, const BodiesBefore& before, BodiesMotion& carried);

/// Transfers the state of another body to a block cut from it: the affine field nearest to that of the mass. The mean
/// and a least-squares fit of the remainder keep momentum and angular momentum.
void carry_field(const SceneParts& scene, ElementIndex e, const std::vector<FieldPoint>& field, BodiesMotion& carried);

/// Returns the mean memory of the rock over the block; its elastic strain is the remainder of the current strain.
YieldState carried_memory(ElementIndex old, const std::vector<FieldPoint>& field, const BodiesBefore& before);

}  // namespace keyblock
