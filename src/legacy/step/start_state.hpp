// The state before the first step, from the materials as the old programs read them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/state.hpp"

namespace keyblock {

/// Start velocities and initial stress (stress = s + y_centroid × gradient).
State start_state(const Model& model, const Settings& settings);

/// Largest component of the start velocities by which the first automatic step is chosen: under the quirk those of the
/// engine's slots 11 to 13 (legacy-rules 13).
double greatest_start_speed(const Model& model, const Settings& settings);

}  // namespace keyblock
