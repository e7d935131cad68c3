// Mass, with the velocity carried from the last step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "terms/term.hpp"

namespace keyblock {

/// ∫ ρ TᵀT over the element, n × n; area moments of the current polygon, constant density (legacy-rules 7).
UnknownBlock mass_matrix(const Basis& basis, const Moments& moments, double density);

/// Shi 1988, inertia of the constant-acceleration step: K += 2M/dt², F += (2/dt) M k v0 with the carry-over
/// k.
void add_inertia(const StepContext& context, System& system);

}  // namespace keyblock
