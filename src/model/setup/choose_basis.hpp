// Gives each block the unknowns it needs: none if it is fixed, three or six if it may move.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/model.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Gives every block the basis of its material, fixed or not, because the legacy rules hold blocks by springs.
Model with_moving_bases(Model model, const PerMaterial<BlockBasis>& basis);

/// Gives every block the basis of its material, except that a block with two or more fixed points is `fixed` if none of
/// them is driven. Two points leave a rigid body no motion; a file that holds a block so means boundary. A block that
/// is fixed during the run has moved and keeps its unknowns.
Model with_bases(Model model, const PerMaterial<BlockBasis>& basis);

/// Returns true if a fixed point of the model lies on an element that may move.
bool has_held_moving_element(const Model& model);

}  // namespace keyblock
