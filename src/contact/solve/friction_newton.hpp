// Newton's method for contact forces: one linear system an active set, with a proximal term where it needs one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/solve/frictional_problem.hpp"

namespace keyblock {

/// Semismooth Newton on the natural map. A proximal term ρ W_ii (λ − λ_ref) makes redundant contacts regular and far
/// steps short; λ_ref follows round by round until the residual of the problem itself is at its goal (Rockafellar
/// 1976). A round whose active sets go round in a cycle or run away is the last; of few pairs one with a larger ρ
/// follows. Where springs make the forces unique, rounds have no such term. The best forces seen are kept.
FrictionalSolution newton(const FrictionalProblem& problem, const Eigen::VectorXd& start);

/// The same from an earlier solution, whose counts go on; `kept` as in `solve`.
FrictionalSolution newton(const FrictionalProblem& problem, FrictionalSolution so_far, KeptSystem* kept = nullptr,
                          Tried first = {});

}  // namespace keyblock
