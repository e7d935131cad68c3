// A cut mesh and an analysis to a model: one element a manifold element.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/model.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

/// Elements keep their numbers and their covers', vertices are their corners. No element has unknowns yet. Materials
/// out of range, and loads beyond the curves, as with blocks.
Model model_from_manifold(const Manifold& manifold, const ElementPoints& points, const Analysis& analysis);

}  // namespace keyblock
