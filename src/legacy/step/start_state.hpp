// Computes the state before the first step from the materials, as Shi's programs read them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/state.hpp"

namespace keyblock {

/// Returns the state with start velocities and initial stress (stress = s + y_centroid × gradient).
State start_state(const Model& model, const Settings& settings);

/// Returns the largest component of the start velocities, which chooses the first automatic step. Under the quirk these
/// are the engine's slots 11 to 13 (legacy-rules 13).
double greatest_start_speed(const Model& model, const Settings& settings);

}  // namespace keyblock
