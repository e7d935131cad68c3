// Uses a factorisation once or for several loads; see sparse_solve.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/sparse_solve.hpp"

#include <cmath>

namespace keyblock {
namespace {

// Limit on the residual: a load that a semidefinite matrix cannot carry stays as residual.
constexpr double kCarried = 1e-6;

}  // namespace

SparseSolution solve(const SparseSystem& system, Definiteness definiteness) {
  SparseFactor factor(system.lower(), definiteness);
  factor.factorise(system.lower());
  return solve(system, factor);
}

SparseSolution solve(const SparseSystem& system, const SparseFactor& factor) {
  SparseFactor::Refined refined = factor.solve_refined(system.load());
  SparseSolution solution;
  solution.x = std::move(refined.x);
  solution.refinements = refined.refinements;
  solution.factor_entries = factor.entries();
  const Eigen::VectorXd left = system.load() - system.times(solution.x);
  const double norm = system.size_of_loads();
  solution.residual = !std::isfinite(norm) ? norm : norm > 0 ? left.norm() / norm : left.norm();
  if (!(solution.residual < kCarried)) throw NotPositiveDefinite("the load moves a body that is not supported");
  return solution;
}

}  // namespace keyblock
