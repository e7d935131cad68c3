// A static equilibrium by dynamic relaxation.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/time/standard_step.hpp"

namespace keyblock {

/// Steps in a time of its own, loads and driven points held as at `time`, every velocity set to zero where the kinetic
/// energy falls (Otter 1965, Cundall 1976), until it stays below a share of the work done and forces balance. Friction
/// opposes the slip of this motion, overshoots included. A block that comes further than its own size is named as one
/// that accelerates.
StandardStep relaxation_step(const StandardScene& scene, const Motion& start, double time);

}  // namespace keyblock
