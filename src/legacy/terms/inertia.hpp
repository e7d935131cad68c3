// Assembles the mass, with the velocity carried from the last step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/terms/term.hpp"

namespace keyblock {

/// Adds the inertia of the constant-acceleration step (Shi 1988): K += 2M/dt², F += (2/dt) M k v0 with the carry-over
/// k.
void add_inertia(const StepContext& context, System& system);

}  // namespace keyblock
