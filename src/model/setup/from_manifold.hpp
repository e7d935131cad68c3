// Builds a model from a cut mesh and an analysis: one element per manifold element.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/model.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// Builds the model. Elements keep their numbers and those of their covers; vertices are their corners. No element has
/// unknowns yet. Materials out of range, and loads beyond the curves, are treated as for blocks.
Model model_from_manifold(const Manifold& manifold, const ElementPoints& points, const Analysis& analysis);

}  // namespace keyblock
