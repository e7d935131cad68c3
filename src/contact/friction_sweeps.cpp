// One sweep over all pairs after another, until the residual of the natural map is small.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/friction_sweeps.hpp"

#include <algorithm>

namespace keyblock {
namespace {

// The residual costs as much as a sweep: it is looked at this often.
constexpr int kLook = 10;

double row_times(const FrictionalProblem& p, Eigen::Index row, const Eigen::VectorXd& forces) {
  double sum = p.b[row];
  for (ContactMatrix::InnerIterator w(p.w, row); w; ++w) sum += w.value() * forces[w.col()];
  return sum;
}

void sweep_once(const FrictionalProblem& p, const Eigen::VectorXd& diagonal, Eigen::VectorXd& forces) {
  for (std::size_t i = 0; i < p.count(); ++i) {
    const auto n = static_cast<Eigen::Index>(2 * i);
    const Eigen::Index t = n + 1;
    const double normal = forces[n] - row_times(p, n, forces) / diagonal[n];
    const bool open = normal <= p.laws[i].least;
    forces[n] = open ? p.laws[i].least : normal;
    const double limit = open ? p.laws[i].limit_open() : p.laws[i].limit(normal);
    forces[t] = std::clamp(forces[t] - row_times(p, t, forces) / diagonal[t], -limit, limit);
  }
}

}  // namespace

FrictionalSolution sweep(const FrictionalProblem& problem, FrictionalSolution solution, int most_sweeps) {
  const Eigen::VectorXd diagonal = problem.w.diagonal();
  Eigen::VectorXd forces = solution.forces;
  for (int i = 1; i <= most_sweeps && solution.residual > problem.acceptable; ++i) {
    sweep_once(problem, diagonal, forces);
    ++solution.sweeps;
    if (i % kLook != 0 && i != most_sweeps) continue;
    const double now = residual(problem, forces);
    if (i < most_sweeps && now >= solution.residual) continue;
    solution.residual = now;
    solution.forces = forces;
  }
  return solution;
}

}  // namespace keyblock
