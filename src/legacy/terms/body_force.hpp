// Assembles the weight of each block into the right-hand side.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/terms/term.hpp"

namespace keyblock {

/// Adds F += ∫ Tᵀ w with w = weight_per_area: density × gravity, or each material's own unit weight if the quirk
/// weight_of_first_material is off (legacy-rules 7.3).
void add_body_force(const StepContext& context, System& system);

}  // namespace keyblock
