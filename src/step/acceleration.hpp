// Accelerations that integrators carry from step to step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/standard_scene.hpp"

namespace keyblock {

/// M⁻¹ (F + initial stress − K q − C v + Gᵀ λ), λ the remembered forces of closed touches.
UnknownsTable balanced_acceleration(const StandardScene& scene, const Motion& motion, double time);

/// The accelerations of `motion` less what closed touches allow no more: along the normal, and along the edge of those that
/// stick. A position kept by a multiplier leaves the acceleration of the step before with its sign turned, (β−½)/β of it,
/// which the average acceleration would never lose.
UnknownsTable with_closed_at_ease(const StandardScene& scene, const Motion& motion);

}  // namespace keyblock
