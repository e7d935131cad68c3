// What makes and keeps the factor of a large square matrix, whoever does it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>

namespace keyblock {

/// The factor of a matrix whose values may change while its pattern stays. Which part of the matrix is looked at, and
/// what is thrown where it has no factor, each kind says. Not for two threads at once.
class LinearFactor {
 public:
  virtual ~LinearFactor() = default;

  virtual void factorise(const Eigen::SparseMatrix<double>& matrix) = 0;
  /// A⁻¹ `right`, column by column.
  virtual Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const = 0;
  /// A⁻ᵀ `right`: what a symmetric matrix answers, too, is the other for one that is not.
  virtual Eigen::MatrixXd solve_transposed(const Eigen::MatrixXd& right) const = 0;
  /// Entries of the factor.
  virtual double entries() const = 0;
};

}  // namespace keyblock
