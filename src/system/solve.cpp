// Chooses between the block factor and iterations, refines once where needed, and measures the residual.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/solve.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "system/block_iterations.hpp"

namespace keyblock {
namespace {

// Residual of iterations. At 1e-11 a grid of 401 blocks leaves the factor within 40 steps, by 4e-5 and in passes,
// because contact decisions see what is left; at 1e-13 it stays to 4e-13, for a fifth more time, and a smaller residual
// changes nothing more.
constexpr double kIterated = 1e-13;
// Measured on walls of bricks, blocks of six unknowns (step_bench --ratio): below so many blocks the factor wins.
// Above, gradients win up to this ratio, and up to so many iterations, which cost what a factor does: 9 to 14 ms beside
// 0.1 ms an iteration at 916 blocks, 210 to 240 ms beside 0.7 at 4,936, 540 ms beside 1.8 at 9,851.
constexpr int kFewBlocks = 300;
constexpr int kManyBlocks = 4000;
constexpr double kGreatestRatio = 400;
constexpr IterationLimits kOfFewer{kIterated, 100};
constexpr IterationLimits kOfMany{kIterated, 250};
constexpr IterationLimits kGiven{kIterated, 5000};
// The old programs' factor of over-relaxation and their bound of sweeps, roughly.
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
  if (!std::isfinite(load)) return load;  // its square overflows: nothing is small against it
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

// With its values; none where a pivot breaks down.
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
  // Refined once, whatever the residual: it finds the small entries that the norm does not see, and impacts multiply
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
