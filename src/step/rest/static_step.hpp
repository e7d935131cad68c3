// A static equilibrium from the one before.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/newton/tolerances.hpp"
#include "step/time/standard_step.hpp"

namespace keyblock {

/// Positions at rest under the scene's share of the loads at `time`, held points where they are driven to by then,
/// nearest to those of `start`: the proximal point iteration
/// (Rockafellar 1976) with mass as the metric,
///     (K + M/τ²) Δq = F + σ0 − K q + Gᵀ λ,
/// which is an implicit step of τ from rest, so that blocks held by contact alone are held. τ grows until the first
/// term alone counts. Friction opposes the slip since `start`, or since the last touch closed that was open there. A
/// block that comes further than its own size is named as one that accelerates.
StandardStep static_step(const StandardScene& scene, const Motion& start, double time,
                         int most_iterations = tolerances::of_statics::kMostIterations);

}  // namespace keyblock
