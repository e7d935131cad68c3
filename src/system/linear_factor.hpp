// Declares the interface of factorisations of a large square matrix.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>

namespace keyblock {

/// Factorisation of a matrix whose values may change while its pattern stays. Each kind states which part of the matrix
/// it reads, and what it throws if the factorisation fails. Not for two threads at once.
class LinearFactor {
 public:
  virtual ~LinearFactor() = default;

  virtual void factorise(const Eigen::SparseMatrix<double>& matrix) = 0;
  /// Returns A⁻¹ `right`, column by column.
  virtual Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const = 0;
  /// Returns A⁻ᵀ `right`; for a symmetric matrix the same as `solve`.
  virtual Eigen::MatrixXd solve_transposed(const Eigen::MatrixXd& right) const = 0;
  /// Returns the number of entries of the factors.
  virtual double entries() const = 0;
};

}  // namespace keyblock
