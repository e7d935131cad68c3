// One sweep over all contacts after another, until the residual of the natural map is small.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/friction_sweeps.hpp"

#include <algorithm>

namespace keyblock {
namespace {

// Linear convergence: beyond this many sweeps a smaller step is cheaper than patience.
constexpr int kMostSweeps = 5000;

void sweep_once(const FrictionalProblem& p, Eigen::VectorXd& forces) {
  for (std::size_t i = 0; i < p.count(); ++i) {
    const auto n = static_cast<Eigen::Index>(2 * i);
    const Eigen::Index t = n + 1;
    forces[n] = std::max(0.0, forces[n] - (p.w.row(n).dot(forces) + p.b[n]) / p.w(n, n));
    const double limit = p.friction[i] * forces[n];
    forces[t] = std::clamp(forces[t] - (p.w.row(t).dot(forces) + p.b[t]) / p.w(t, t), -limit, limit);
  }
}

}  // namespace

FrictionalSolution sweep(const FrictionalProblem& problem, FrictionalSolution solution) {
  while (!solution.converged && solution.sweeps < kMostSweeps) {
    sweep_once(problem, solution.forces);
    ++solution.sweeps;
    solution.residual = residual(problem, solution.forces);
    solution.converged = solution.residual <= problem.acceptable;
  }
  return solution;
}

}  // namespace keyblock
