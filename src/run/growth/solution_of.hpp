// What the integrals about crack tips need of a stepper: displacement, and what contact does to the faces of cracks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "fracture/tip_integrals.hpp"
#include "step/stepper.hpp"

namespace keyblock {

/// After the last accepted step; none without bodies on covers, or before anything was solved. Views the stepper.
std::optional<CoverSolution> solution_of(const Stepper& stepper);

/// Displacement, a length, of a point of an element of the manifold that was at `start`.
Point displacement_at(const CoverDisplacement& moved, int element, Point start);

}  // namespace keyblock
