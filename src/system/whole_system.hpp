// Assembles the unsymmetric matrix of many functions with two unknowns each, on a known pattern.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "system/sparse_system.hpp"

namespace keyblock {

/// Matrix A, of which function a has rows and columns 2a and 2a + 1. Couplings outside all groups cannot be added.
class WholeSystem {
 public:
  WholeSystem(int function_count, const FunctionGroups& groups);

  /// Copies the couplings and values of a symmetric system.
  explicit WholeSystem(const SparseSystem& symmetric);

  void clear() { matrix_.coeffs().setZero(); }
  /// Adds `block`, 2n × 2n, of n different functions to A.
  void add_matrix(std::span<const int> functions, const Eigen::MatrixXd& block);
  /// Adds the matrix of a symmetric system to A; it must have as many functions, and no other couplings.
  void add(const SparseSystem& symmetric);

  /// Returns the matrix, compressed, rows ascending.
  const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }

 private:
  double* at(int row, int column);

  Eigen::SparseMatrix<double> matrix_;
};

}  // namespace keyblock
