// Collects the input of the crack-tip integrals from a stepper: displacement, and contact forces on crack faces.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "fracture/tip_integrals.hpp"
#include "step/stepper.hpp"

namespace keyblock {

/// Returns the solution after the last accepted step; empty without NMM bodies or before any solution. Keeps a
/// reference to the stepper.
std::optional<CoverSolution> solution_of(const Stepper& stepper);

/// Returns the displacement [length] of the point at `start` in an element of the manifold.
Point displacement_at(const CoverDisplacement& moved, int element, Point start);

}  // namespace keyblock
