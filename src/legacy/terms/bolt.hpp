// Assembles bolts as axial springs between blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/terms/term.hpp"

namespace keyblock {

/// Adds K += k rᵀr and F −= f rᵀ. l is the current direction of the bolt. r = (−lᵀT at the first end, lᵀT at the
/// second) is the elongation per unit of the unknowns. f is the bolt force at the start of the step (legacy-formats,
/// bolts; linear in the increment, Shi 1988). A bolt whose ends coincide has no direction and exerts no force.
void add_bolt(const StepContext& context, System& system);

}  // namespace keyblock
