// Pairs whose states change each other without end, settled among themselves.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "contact/solve/frictional_problem.hpp"

namespace keyblock {

/// Few pairs as a problem of their own: y = W λ + b with a dense W, whose diagonal is positive.
struct DenseFriction {
  Eigen::MatrixXd w;
  Eigen::VectorXd b;
  std::vector<ForceLaw> laws;
};

/// Forces of a dense problem, by Newton and projected Gauss-Seidel in turn, from `start` until the natural map changes
/// none by more than `goal`, or the best of a named number of sweeps.
Eigen::VectorXd solve_dense(const DenseFriction& problem, Eigen::VectorXd start, double goal);

/// `grips` with those of `pairs` as they settle while all others keep theirs: what these answer is in a Schur
/// complement, two solutions with one factor a pair. `added` stands on the diagonal of W beside its own entries, b is
/// that of y = (W + added) λ + b.
std::vector<Grip> settled_among(const FrictionalProblem& problem, std::vector<Grip> grips,
                                std::span<const std::size_t> pairs, const Eigen::VectorXd& added,
                                const Eigen::VectorXd& b, const Eigen::VectorXd& forces);

}  // namespace keyblock
