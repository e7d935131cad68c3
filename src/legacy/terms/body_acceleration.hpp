// Assembles a given acceleration of all blocks into the right-hand side.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/terms/term.hpp"

namespace keyblock {

/// Adds F += ∫ ρ Tᵀ a over the element, with a at the end of the step, as for point loads (legacy-rules 7.3).
void add_body_acceleration(const StepContext& context, System& system);

}  // namespace keyblock
