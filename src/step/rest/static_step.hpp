// Computes a static equilibrium from the last one, by a proximal point iteration. Theory:
// docs/theory/07-initial-state-and-statics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/newton/tolerances.hpp"
#include "step/time/standard_step.hpp"

namespace keyblock {

/// Finds equilibrium positions under the scene's load fraction at `time`, with fixed points at their targets of that
/// time. Among several positions it finds those nearest to `start`. Proximal point iteration (Rockafellar 1976) with
/// mass as the metric:
///   (K + M/τ²) Δq = F + σ0 − K q + Gᵀ λ.
/// This is an implicit step of τ without initial velocity, so that even blocks held by contact alone are stable. τ
/// grows until the term M/τ² becomes negligible. Friction opposes the slip since `start`, or since the last contact
/// closed that was open there. A block that moves farther than its own size is reported as accelerating.
StandardStep static_step(const StandardScene& scene, const Motion& start, double time,
                         int most_iterations = tolerances::of_statics::kMostIterations);

}  // namespace keyblock
