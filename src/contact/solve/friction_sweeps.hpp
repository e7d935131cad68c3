// Projected Gauss-Seidel on frictional contact: slow, but it does not go round in cycles of active sets.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/solve/frictional_problem.hpp"

namespace keyblock {

/// Continues from the forces of `solution`, normal then tangential of each pair in turn (Jean 1999, contact by
/// contact), until the residual is acceptable or `most_sweeps` are made.
FrictionalSolution sweep(const FrictionalProblem& problem, FrictionalSolution solution, int most_sweeps);

}  // namespace keyblock
