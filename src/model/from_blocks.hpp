// Blocks and an analysis to a model: one affine element a block.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/model.hpp"
#include "model/settings.hpp"
#include "model/state.hpp"

namespace keyblock {

/// Block materials and joint materials out of range are taken as the nearest one that exists (the check of
/// the problem warns of them). Horizontal body forces of manifold files act on no block. Loads are given to loading points in order; points beyond the curves carry
/// none.
Model model_from_blocks(const Blocks& blocks, const Analysis& analysis);

/// The state before the first step: start velocities and initial stress (stress = s + y_centroid × gradient).
State start_state(const Model& model, AnalysisDialect dialect, const Settings& settings);

/// What the Berkeley engine has in its material slots 8-10: stress gradient and start velocity (legacy-rules 7.5, 16.1).
Velocity berkeley_start_velocity(const BlockMaterial& material, AnalysisDialect dialect);

/// What it has in slots 11-13: read by the first automatic step alone (legacy-rules 13).
Velocity berkeley_step_velocity(const BlockMaterial& material, AnalysisDialect dialect);

}  // namespace keyblock
