// Solves for contact forces by a semismooth Newton method: one linear system per active set, regularised by a proximal
// term if contacts are redundant. Theory: docs/theory/05-frictional-contact.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/solve/frictional_problem.hpp"

namespace keyblock {

/// Returns true if springs make the forces of contacts unique. Under multipliers redundant forces have many solutions.
bool has_unique_forces(const FrictionalProblem& problem);

/// Returns true if, in motion, no pair of few slides under these forces, and the residual of each is little of its own
/// force. Such forces are the answer once they are acceptable: redundant forces have many solutions, and a clamped
/// block must not creep from one to the next. False for forces with a proximal term of their own.
bool holds(const FrictionalProblem& problem, const Tried& tried);

/// Applies semismooth Newton to the natural map. A proximal term ρ W_ii (λ − λ_ref) makes redundant contacts regular
/// and shortens long steps. λ_ref follows from round to round until the residual of the problem itself reaches its goal
/// (Rockafellar 1976). A round whose active sets cycle or diverge is the last; with few pairs, one with a larger ρ
/// follows. If springs make the forces unique, rounds have no such term. The best forces found are kept.
FrictionalSolution newton(const FrictionalProblem& problem, const Eigen::VectorXd& start);

/// Continues from an earlier solution and its counts; `kept` as in `solve`.
FrictionalSolution newton(const FrictionalProblem& problem, FrictionalSolution so_far, KeptSystem* kept = nullptr,
                          Tried first = {});

}  // namespace keyblock
