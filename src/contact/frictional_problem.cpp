// The natural map, its residual, and the order in which the two methods are tried.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/frictional_problem.hpp"

#include <algorithm>

#include "contact/friction_newton.hpp"
#include "contact/friction_sweeps.hpp"

namespace keyblock {

NaturalMap natural_map(const FrictionalProblem& problem, const Eigen::VectorXd& forces) {
  const Eigen::VectorXd y = problem.w * forces + problem.b;
  NaturalMap map{forces, {}};
  for (std::size_t i = 0; i < problem.count(); ++i) {
    const auto n = static_cast<Eigen::Index>(2 * i);
    const Eigen::Index t = n + 1;
    const double normal = std::max(0.0, forces[n] - y[n] / problem.w(n, n));
    const double limit = problem.friction[i] * normal;
    const double tangential = forces[t] - y[t] / problem.w(t, t);
    map.forces[n] = normal;
    map.forces[t] = std::clamp(tangential, -limit, limit);
    const Grip sliding = tangential > 0 ? Grip::slip_forward : Grip::slip_backward;
    const bool holds = limit > 0 && std::abs(tangential) <= limit;
    map.grips.push_back(normal <= 0 ? Grip::open : holds ? Grip::stick : sliding);
  }
  return map;
}

double residual(const FrictionalProblem& problem, const Eigen::VectorXd& forces) {
  if (problem.count() == 0) return 0;
  return (natural_map(problem, forces).forces - forces).cwiseAbs().maxCoeff();
}

FrictionalSolution solve(const FrictionalProblem& problem, const Eigen::VectorXd& start) {
  FrictionalSolution solution = newton(problem, start);
  solution.converged = solution.residual <= problem.acceptable;
  if (!solution.converged) solution = sweep(problem, std::move(solution));
  // Round-off on an open contact would pass for a closed one.
  const NaturalMap map = natural_map(problem, solution.forces);
  for (std::size_t i = 0; i < problem.count(); ++i)
    if (map.grips[i] == Grip::open) solution.forces.segment<2>(static_cast<Eigen::Index>(2 * i)).setZero();
  return solution;
}

}  // namespace keyblock
