// Accelerations that integrators carry from step to step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// M⁻¹ (F + initial stress − K q − C v + Gᵀ λ), λ the remembered forces of closed touches, bolts and held points.
UnknownsTable balanced_acceleration(const StandardScene& scene, const Motion& motion, double time);

/// The accelerations of `motion` less what multipliers allow no more: of closed touches along the normal, of those that
/// stick along the edge too, and of held points. A position kept by a multiplier leaves the acceleration of the step
/// before with its sign turned, (β−½)/β of it, which the average acceleration would never lose.
UnknownsTable with_held_at_ease(const StandardScene& scene, const Motion& motion);

}  // namespace keyblock
