// Chooses between the block factorisation and iterations, refines once if needed, and computes the residual.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/solve.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "system/block_iterations.hpp"

namespace keyblock {
namespace {

// Residual of iterations. At 1e-11 a grid of 401 blocks departs from the factorisation within 40 steps, by 4e-5 and in
// open–close iterations, because contact decisions depend on the remainder. At 1e-13 it agrees to 4e-13, for a fifth
// more time. A smaller residual changes nothing more.
constexpr double kIterated = 1e-13;
// Limits measured on walls of bricks, blocks of six unknowns (step_bench --ratio). Below so many blocks the
// factorisation is faster. Above, conjugate gradients are faster up to this ratio, and up to so many iterations, which
// cost as much as a factorisation. At 916 blocks it takes 9 to 14 ms and an iteration 0.1 ms. At 4,936 blocks these are
// 210 to 240 ms and 0.7 ms, at 9,851 blocks 540 ms and 1.8 ms.
constexpr int kFewBlocks = 300;
constexpr int kManyBlocks = 4000;
constexpr double kGreatestRatio = 400;
constexpr IterationLimits kOfFewer{kIterated, 100};
constexpr IterationLimits kOfMany{kIterated, 250};
constexpr IterationLimits kGiven{kIterated, 5000};
// Factor of over-relaxation of Shi's programs, and roughly their bound on sweeps.
constexpr double kOmega = 1.4;
constexpr IterationLimits kSweeps{kIterated, 3000};

BlockPattern::Pairs coupled_in(const BlockMatrix& matrix) {
  BlockPattern::Pairs pairs;
  for (int i = 0; i < matrix.block_count(); ++i)
    for (const auto& entry : matrix.row(i))
      if (entry.column != i) pairs.emplace_back(i, entry.column);
  return pairs;
}

double relative_residual(const System& system, const Eigen::VectorXd& residual) {
  const double load = system.load.norm();
  if (!std::isfinite(load)) return load;  // its square overflows: no residual is small against it
  return load > 0 ? residual.norm() / load : residual.norm();
}

std::span<double> entries(Eigen::VectorXd& x) {
  return {x.data(), static_cast<std::size_t>(x.size())};
}

}  // namespace

bool Solver::iterates(int block_count, double stiffness_over_inertia) const {
  if (method != LinearMethod::automatic) return method != LinearMethod::factor;
  return !gave_up_iterations && block_count >= kFewBlocks && stiffness_over_inertia <= kGreatestRatio;
}

// Returns the factorisation of the matrix, or null if a pivot fails.
std::unique_ptr<BlockFactor> Solver::factor_of(const BlockMatrix& matrix, MatrixShape shape) {
  std::vector<int> sizes;
  for (int i = 0; i < matrix.block_count(); ++i) sizes.push_back(matrix.size(i));
  std::unique_ptr<BlockFactor> factor = factors_.take(sizes, coupled_in(matrix), shape);
  for (int i = 0; i < matrix.block_count(); ++i) {
    for (const auto& [column, block] : matrix.row(i)) {
      factor->add(i, column, block);
      if (column != i && shape == MatrixShape::general) factor->add(column, i, block.transpose());
    }
  }
  if (factor->factorise()) return factor;
  factors_.give_back(std::move(factor));
  return nullptr;
}

std::optional<Eigen::VectorXd> Solver::by_factor(const System& system) {
  std::unique_ptr<BlockFactor> factor = factor_of(system.matrix, MatrixShape::symmetric);
  if (!factor) factor = factor_of(system.matrix, MatrixShape::general);  // not positive: as any other matrix
  if (!factor) return std::nullopt;
  Eigen::VectorXd x = system.load;
  factor->solve(entries(x));
  // Refined once for every residual: this finds the small entries that the norm does not show, and impacts multiply
  // errors by ten.
  Eigen::VectorXd correction = system.load - system.matrix * x;
  factor->solve(entries(correction));
  x += correction;
  factors_.give_back(std::move(factor));
  return x;
}

std::optional<Solution> Solver::by_iterations(const System& system, const Eigen::VectorXd& guess) const {
  const Eigen::VectorXd start = guess.size() == system.load.size() ? guess : Eigen::VectorXd::Zero(system.load.size());
  const IterationLimits& limits = method == LinearMethod::conjugate_gradients ? kGiven
                                  : system.matrix.block_count() < kManyBlocks ? kOfFewer
                                                                              : kOfMany;
  IterationResult result = method == LinearMethod::over_relaxation
                               ? over_relaxation(system.matrix, system.load, start, kOmega, kSweeps)
                               : conjugate_gradients(system.matrix, system.load, start, limits);
  if (!result.converged || !result.x.allFinite()) return std::nullopt;
  return Solution{std::move(result.x), result.residual};
}

std::optional<Solution> Solver::solve(const System& system, const SystemKind& kind) {
  if (iterates(system.matrix.block_count(), kind.stiffness_over_inertia)) {
    std::optional<Solution> solution = by_iterations(system, kind.guess);
    if (solution || method == LinearMethod::over_relaxation) return solution;
    gave_up_iterations = true;
  }
  std::optional<Eigen::VectorXd> x = by_factor(system);
  if (!x || !x->allFinite()) return std::nullopt;
  const double residual = relative_residual(system, system.load - system.matrix * *x);
  return Solution{*std::move(x), residual};
}

}  // namespace keyblock
