// Computes the state after an accepted step, and the initial velocity of a step. Theory: docs/theory/13-shis-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/contact/judge.hpp"
#include "model/state.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Moves vertices and points, adds the stress of the strain increment, and recomputes centroids and moments
/// (legacy-rules 12; stress is not rotated). Without the quirk velocity_from_coming_step it also sets v = 2 d/dt - v0.
/// `node_steps`: displacement of each node that elements share.
State update(const Model& model, State state, const Settings& settings, const Increments& increments, double dt,
             const std::vector<Point>& node_steps = {});

/// Returns the state with v = 2 d/dt - k v0 of the constant-acceleration step (Shi 1988). d is the last accepted
/// increment, k the velocity carry-over. Under the quirk `dt` is the next step, and this is applied at every attempt
/// (legacy-rules 7.4).
State with_velocity_of_last_step(const Model& model, State state, const Settings& settings, double dt);

}  // namespace keyblock
