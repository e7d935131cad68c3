// Assembles stiff springs that hold the fixed points, or drive them along a given motion.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/terms/term.hpp"

namespace keyblock {

/// Adds K += k TᵀT and F += k Tᵀ c at the current place of the point. k = fixed_point_factor × initial contact penalty.
/// c = given motion at the end of the step minus the drift so far (legacy-rules 7.1).
void add_fixed_point(const StepContext& context, System& system);

}  // namespace keyblock
