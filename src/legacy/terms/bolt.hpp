// Axial springs between blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/terms/term.hpp"

namespace keyblock {

/// With l the present direction of the bolt and r = (−lᵀT at the first end, lᵀT at the second) the elongation per unit
/// of the unknowns:  K += k rᵀr,  F −= f rᵀ,  f the force the bolt has at the start of the step (legacy-formats, bolts;
/// linear in the increment, Shi 1988). A bolt whose ends meet has no direction and acts not.
void add_bolt(const StepContext& context, System& system);

}  // namespace keyblock
