// Contact forces by way of the interior of their bounds: the fall-back where active sets go round in cycles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/solve/frictional_problem.hpp"

namespace keyblock {

/// Follows the central path of Coulomb's law as a complementarity problem, from the forces of `so_far`: with the rooms
///     λn − least,   cohesion + friction λn ± λt,
/// each has a multiplier, and their products go to zero together. A step is that of Newton's method with Mehrotra's
/// prediction and correction (1992). Friction is not the gradient of anything, so that the path may turn back: a step
/// that is cut short adds a share of W_ii to the matrix of the next one, and to nothing else (Levenberg 1944), which
/// lets it leave the path there. The best forces seen are kept; it ends at the goal, or after a number of systems that
/// depends on nothing.
FrictionalSolution interior_forces(const FrictionalProblem& problem, FrictionalSolution so_far);

}  // namespace keyblock
