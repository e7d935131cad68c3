// Hands the block matrix to Eigen's sparse factorisation, refines once where needed, and measures the residual.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/solve.hpp"

#include <algorithm>
#include <vector>

namespace keyblock {
namespace {

// A residual above this asks for one step of refinement: a backward-stable factorisation stays well below it.
constexpr double kRefineAbove = 1e-12;

// Lower triangle, column by column: the stored upper blocks of block row i are the lower blocks of block
// column i.
Eigen::SparseMatrix<double> lower_triangle(const BlockMatrix& matrix) {
  Eigen::SparseMatrix<double> lower(matrix.row_count(), matrix.row_count());
  std::vector<int> column_sizes;
  for (int i = 0; i < matrix.block_count(); ++i) {
    int below = 0;
    for (const auto& entry : matrix.row(i)) below += entry.column == i ? 0 : matrix.size(entry.column);
    for (int c = 0; c < matrix.size(i); ++c) column_sizes.push_back(matrix.size(i) - c + below);
  }
  lower.reserve(column_sizes);
  for (int i = 0; i < matrix.block_count(); ++i) {
    for (int c = 0; c < matrix.size(i); ++c) {
      for (const auto& [j, block] : matrix.row(i)) {
        for (int r = j == i ? c : 0; r < matrix.size(j); ++r)
          lower.insert(matrix.first_row(j) + r, matrix.first_row(i) + c) = block(c, r);
      }
    }
  }
  lower.makeCompressed();
  return lower;
}

double relative_residual(const System& system, const Eigen::VectorXd& residual) {
  const double load = system.load.norm();
  return load > 0 ? residual.norm() / load : residual.norm();
}

}  // namespace

bool Solver::same_pattern(const Sparse& matrix) const {
  return matrix.rows() == matrix_.rows() && matrix.nonZeros() == matrix_.nonZeros() &&
         std::equal(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.outerSize() + 1, matrix_.outerIndexPtr()) &&
         std::equal(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros(), matrix_.innerIndexPtr());
}

std::optional<Solution> Solver::solve(const System& system) {
  Sparse matrix = lower_triangle(system.matrix);
  if (!same_pattern(matrix)) factor_->analyzePattern(matrix);
  matrix_ = std::move(matrix);
  factor_->factorize(matrix_);
  if (factor_->info() != Eigen::Success) return std::nullopt;
  Solution solution{factor_->solve(system.load), 0};
  Eigen::VectorXd residual = system.load - system.matrix * solution.x;
  if (relative_residual(system, residual) > kRefineAbove) {
    solution.x += factor_->solve(residual);
    residual = system.load - system.matrix * solution.x;
  }
  solution.residual = relative_residual(system, residual);
  if (!solution.x.allFinite()) return std::nullopt;
  return solution;
}

}  // namespace keyblock
