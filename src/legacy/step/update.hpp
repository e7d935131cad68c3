// The state after an accepted step, and the velocity a step starts with.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/contact/judge.hpp"
#include "model/state.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Moves vertices and points, adds the stress of the strain increment, takes centroids and moments anew
/// (legacy-rules 12; stress is not rotated). With the quirk velocity_from_coming_step off, also sets v = 2
/// d/dt - v0. `node_steps`: how far each node that elements share goes.
State update(const Model& model, State state, const Settings& settings, const Increments& increments, double dt,
             const std::vector<Point>& node_steps = {});

/// v = 2 d/dt - k v0 of the constant-acceleration step (Shi 1988), d the last accepted increment, k the
/// carry-over of velocity. Under the quirk `dt` is the step about to be done, and this is applied at every
/// attempt (legacy-rules 7.4).
State with_velocity_of_last_step(const Model& model, State state, const Settings& settings, double dt);

}  // namespace keyblock
