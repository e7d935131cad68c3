// Scaling, CHOLMOD, refinement; see sparse_solve.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/sparse_solve.hpp"

#include <Eigen/CholmodSupport>
#include <cmath>

namespace keyblock {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr double kPerturbation = 1e-11;  // of a diagonal of ones: 1 to 2 refinements, against 3 with 1e-8
constexpr int kMostRefinements = 6;
constexpr double kSmallEnough = 1e-15;
// Smallest over largest pivot: round-off makes some 1e-16 of a zero one. A million unknowns of a plane body leave 1e-7.
constexpr double kSingular = 1e-13;
// A load that a semidefinite matrix cannot carry stays as residual.
constexpr double kCarried = 1e-6;

class Factor : public Eigen::CholmodSupernodalLLT<Sparse, Eigen::Lower> {
 public:
  double pivot_ratio() { return cholmod_rcond(m_cholmodFactor, &cholmod()); }
};

/// 1/√a_ii.
Eigen::VectorXd scaling_of(const Sparse& lower) {
  Eigen::VectorXd scale(lower.cols());
  for (int j = 0; j < lower.cols(); ++j) {
    const double diagonal = lower.valuePtr()[lower.outerIndexPtr()[j]];
    if (!(diagonal > 0)) throw NotPositiveDefinite("the matrix has a diagonal entry that is not positive");
    scale(j) = 1 / std::sqrt(diagonal);
  }
  return scale;
}

}  // namespace

SparseSolution solve(const SparseSystem& system, Definiteness definiteness) {
  const Eigen::VectorXd scale = scaling_of(system.lower());
  Sparse scaled = scale.asDiagonal() * system.lower() * scale.asDiagonal();
  Factor factor;
  factor.cholmod().print = 0;
  if (definiteness == Definiteness::semidefinite) factor.setShift(kPerturbation);
  factor.compute(scaled);
  if (factor.info() != Eigen::Success)
    throw NotPositiveDefinite("the matrix is not positive definite: a body is not held, or a penalty is too small");
  if (definiteness == Definiteness::definite && factor.pivot_ratio() < kSingular)
    throw NotPositiveDefinite("the matrix is singular: a body is not held");

  SparseSolution solution;
  solution.factor_entries = factor.cholmod().lnz;
  const Eigen::VectorXd load = scale.asDiagonal() * system.load();
  const auto residual_of = [&](const Eigen::VectorXd& y) -> Eigen::VectorXd {
    return load - scaled.selfadjointView<Eigen::Lower>() * y;
  };
  Eigen::VectorXd y = factor.solve(load);
  Eigen::VectorXd residual = residual_of(y);
  const double size = load.norm() > 0 ? load.norm() : 1;
  while (solution.refinements < kMostRefinements && residual.norm() > kSmallEnough * size) {
    const Eigen::VectorXd better = y + factor.solve(residual);
    const Eigen::VectorXd left = residual_of(better);
    if (!(left.norm() < 0.5 * residual.norm())) break;
    y = better;
    residual = left;
    ++solution.refinements;
  }
  solution.x = scale.asDiagonal() * y;
  const Eigen::VectorXd unscaled = system.load() - system.lower().selfadjointView<Eigen::Lower>() * solution.x;
  const double norm = system.load().norm();
  solution.residual = norm > 0 ? unscaled.norm() / norm : unscaled.norm();
  if (!(solution.residual < kCarried)) throw NotPositiveDefinite("the load moves a body that is not held");
  return solution;
}

}  // namespace keyblock
