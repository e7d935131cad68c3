// Assembles the stress that the element brings into the step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/terms/term.hpp"

namespace keyblock {

/// Adds F -= S Bᵀ s with the current area S (Shi 1988, initial stress submatrix).
void add_initial_stress(const StepContext& context, System& system);

}  // namespace keyblock
