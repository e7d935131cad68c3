// Computes the accelerations that integrators pass from step to step. Theory: docs/theory/03-time-integration.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/scene/standard_scene.hpp"

namespace keyblock {

/// Returns M⁻¹ (F + initial stress − K q − C v + Gᵀ λ), λ the remembered forces of closed contacts, bolts and fixed
/// points.
UnknownsTable balanced_acceleration(const StandardScene& scene, const Motion& motion, double time);

/// Returns the accelerations of `motion` without the parts that multipliers suppress. These act along the normal of
/// closed contacts, along the edge of sticking ones, and at fixed points. If a multiplier keeps a position, the last
/// acceleration returns with reversed sign, times (β−½)/β. The average-acceleration rule would never lose it.
UnknownsTable with_held_at_ease(const StandardScene& scene, const Motion& motion);

}  // namespace keyblock
