// The matrix of many functions with two unknowns each, not symmetric, on a pattern known beforehand.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "system/sparse_system.hpp"

namespace keyblock {

/// A, of which function a has rows and columns 2a and 2a + 1. What couples in no group cannot be added.
class WholeSystem {
 public:
  WholeSystem(int function_count, const FunctionGroups& groups);

  /// With the couplings and values of a symmetric one.
  explicit WholeSystem(const SparseSystem& symmetric);

  void clear() { matrix_.coeffs().setZero(); }
  /// A += `block`, 2n × 2n, of n different functions.
  void add_matrix(std::span<const int> functions, const Eigen::MatrixXd& block);
  /// A += the matrix of a symmetric system of as many functions, whose couplings are some of these.
  void add(const SparseSystem& symmetric);

  /// Compressed, rows ascending.
  const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }

 private:
  double* at(int row, int column);

  Eigen::SparseMatrix<double> matrix_;
};

}  // namespace keyblock
