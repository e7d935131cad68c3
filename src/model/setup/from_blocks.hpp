// Builds a model from blocks and an analysis: one affine element per block.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/model.hpp"

namespace keyblock {

/// Builds the model. Material numbers out of range become the nearest that exists (the check of the problem warns of
/// them). Horizontal body forces of manifold files act on no block. Loads are given to loading points in order; points
/// beyond the curves carry none.
Model model_from_blocks(const Blocks& blocks, const Analysis& analysis);

/// Returns a bolt of the blocks between the elements that hold its ends.
Bolt bolt_between(const BlockBolt& bolt, ElementIndex first, ElementIndex second);

}  // namespace keyblock
