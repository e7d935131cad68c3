// Newton's method for contact forces: one linear system an active set, with a proximal term against redundant contacts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/frictional_problem.hpp"

namespace keyblock {

/// Semismooth Newton on the natural map. The proximal term ρ W_ii (λ − λ_ref) makes redundant contacts regular; λ_ref follows
/// round by round until the residual of the problem itself is at its goal (Rockafellar 1976). An active set
/// that comes back is a cycle: the pairs that differ between the two visits are undecided. The best forces seen are kept.
FrictionalSolution newton(const FrictionalProblem& problem, const Eigen::VectorXd& start);

/// The same from an earlier solution, whose counts go on.
FrictionalSolution newton(const FrictionalProblem& problem, FrictionalSolution so_far);

}  // namespace keyblock
