// Computes the initial state of bodies that have no equilibrium and accelerate from the start. Theory:
// docs/theory/07-initial-state-and-statics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// Gives bodies the strains and contact forces of their first accelerations under the loads of t = 0, so that they
/// begin to slide or topple without oscillation. Implicit steps of pseudo time τ from rest, as in `static_step`, lead
/// to constant increments Δq = a τ² without further strain:
///   K q = F + σ0 + Gᵀ λ − M a.
/// Friction opposes the increment and the initial velocity. At the end the increments are taken back, so that no body
/// has moved. Bodies in equilibrium stay there; those that nothing touches accelerate without strain. Returns nothing
/// if the increments do not settle, or if a contact closes on the way.
std::optional<Motion> moving_start(StandardScene scene, const Motion& start);

}  // namespace keyblock
