// Gives each block the unknowns it needs: none where it is held, three or six where it may move.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/model.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Every block gets the basis of its material, held or not: old rules hold blocks by springs.
Model with_moving_bases(Model model, const PerMaterial<BlockBasis>& basis);

/// A block held at two or more places by points that are not driven is `fixed`: two points of a rigid body leave it no
/// motion, and a file that holds a block so means boundary. One that is held in mid-run has moved and keeps its
/// unknowns. Every other block gets the basis of its material.
Model with_bases(Model model, const PerMaterial<BlockBasis>& basis);

/// True if a fixed point of the model sits on an element that may move.
bool has_held_moving_element(const Model& model);

}  // namespace keyblock
