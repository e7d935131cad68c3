// Assembles viscous damping of materials that define it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/terms/term.hpp"

namespace keyblock {

/// Adds Rayleigh's C = a M + b K of each block material: K += C / dt, the force of the mean velocity d / dt of the
/// step.
void add_damping(const StepContext& context, System& system);

}  // namespace keyblock
