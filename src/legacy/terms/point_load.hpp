// Assembles time-dependent loads at the loading points.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/terms/term.hpp"

namespace keyblock {

/// Adds F += Tᵀ p at the current place of the point, p at the end of the step (legacy-rules 7.3).
void add_point_load(const StepContext& context, System& system);

}  // namespace keyblock
