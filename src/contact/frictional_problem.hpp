// Unilateral contact with Coulomb friction as a complementarity problem in the contact forces, and its solution.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace keyblock {

/// y = W λ + b with entries 2i (normal) and 2i + 1 (tangential) of contact i:
///     0 ≤ λn ⊥ yn ≥ 0,   |λt| ≤ μ λn,   λt opposes yt, and yt = 0 while |λt| < μ λn.
/// Compliance of the contact (1/p) stands on the diagonal of W.
struct FrictionalProblem {
  Eigen::MatrixXd w;
  Eigen::VectorXd b;
  std::vector<double> friction;  ///< μ of each contact
  double goal = 0;               ///< residual to aim at, in the unit of λ
  double acceptable = 0;         ///< residual that counts as solved where the goal is out of reach; at least the goal

  std::size_t count() const { return friction.size(); }
};

enum class Grip { open, stick, slip_forward, slip_backward };  ///< slip_forward: λt = +μ λn

struct FrictionalSolution {
  Eigen::VectorXd forces;
  double residual = 0;
  int solves = 0;                      ///< linear solves
  int sweeps = 0;                      ///< of projected Gauss-Seidel, 0 if it was not needed
  bool converged = false;              ///< residual ≤ acceptable
  std::vector<std::size_t> undecided;  ///< contacts whose state went round in a cycle
};

/// What λ would become under the natural map (Alart & Curnier 1991):
///     λn → max(0, λn − rn yn),  λt → clamp(λt − rt yt, ± μ max(0, λn − rn yn)),  r = 1 / W_ii.
struct NaturalMap {
  Eigen::VectorXd forces;
  std::vector<Grip> grips;
};
NaturalMap natural_map(const FrictionalProblem& problem, const Eigen::VectorXd& forces);

/// Largest change of λ by the natural map: zero at the solution and only there.
double residual(const FrictionalProblem& problem, const Eigen::VectorXd& forces);

/// Newton on the natural map from `start`; where that ends above the acceptable residual, projected Gauss-Seidel from
/// the best forces it saw. The forces of open contacts are exactly zero.
FrictionalSolution solve(const FrictionalProblem& problem, const Eigen::VectorXd& start);

}  // namespace keyblock
