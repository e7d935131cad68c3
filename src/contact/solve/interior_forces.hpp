// Solves for contact forces by an interior-point method: the fallback if active sets cycle. Theory:
// docs/theory/05-frictional-contact.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/solve/frictional_problem.hpp"

namespace keyblock {

/// Follows the central path of Coulomb's law as a complementarity problem, from the forces of `so_far`. Each of the
/// rooms
///     λn − least,   cohesion + friction λn ± λt
/// has a multiplier, and all products go to zero together. A step is Newton's, with Mehrotra's prediction and
/// correction (1992). Friction has no potential, so that the path may turn back. After a shortened step, the next
/// matrix alone gets a fraction of W_ii (Levenberg 1944), which lets it leave the path there. The best forces found are
/// kept. The search ends at the goal, or after a fixed number of systems.
FrictionalSolution interior_forces(const FrictionalProblem& problem, FrictionalSolution so_far);

}  // namespace keyblock
