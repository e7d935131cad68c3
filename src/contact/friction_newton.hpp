// Semismooth Newton on the natural map of frictional contact.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/frictional_problem.hpp"

namespace keyblock {

/// Alart & Curnier 1991: the active set of the natural map, one linear solve each. Redundant contacts (a rigid block on two
/// sticking corners) make W singular; a proximal term ρ W_ii (λ − λ_ref) decides among equal solutions, and λ_ref follows
/// until the problem without it is solved (contact-notes 3, step 4).
FrictionalSolution newton(const FrictionalProblem& problem, const Eigen::VectorXd& start);

}  // namespace keyblock
