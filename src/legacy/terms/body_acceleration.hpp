// A given acceleration of all blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/terms/term.hpp"

namespace keyblock {

/// F += ∫ ρ Tᵀ a over the element, a at the end of the step as point loads are (legacy-rules 7.3).
void add_body_acceleration(const StepContext& context, System& system);

}  // namespace keyblock
