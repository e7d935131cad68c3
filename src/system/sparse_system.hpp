// Assembles the symmetric matrix of many functions with two unknowns each, on a known pattern, and its load vector.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>
#include <span>
#include <vector>

namespace keyblock {

/// Lists of functions, one after another: those of an element, or of a pair of elements, which all couple.
class FunctionGroups {
 public:
  void add(std::span<const int> functions);
  int group_count() const { return static_cast<int>(first_.size()) - 1; }
  std::span<const int> group(int g) const;

 private:
  std::vector<int> functions_;
  std::vector<std::size_t> first_{0};
};

/// Linear system A x = b. Function a has rows 2a and 2a + 1; the lower triangle of A is stored. Couplings outside all
/// groups cannot be added.
class SparseSystem {
 public:
  SparseSystem(int function_count, const FunctionGroups& groups);

  /// Adds `block`, symmetric, 2n × 2n, of n different functions to A.
  void add_matrix(std::span<const int> functions, const Eigen::MatrixXd& block);
  /// Adds `part`, 2n, to b.
  void add_load(std::span<const int> functions, const Eigen::VectorXd& part);

  /// Sets A and b to zero.
  void clear();
  /// Adds `factor` times the matrix of `other`, which must have the same groups, to A.
  void add_scaled(double factor, const SparseSystem& other);
  /// Adds the matrix of `other` with a factor for each function, for both columns and rows: coupled functions have the
  /// same one.
  void add_scaled(std::span<const double> factors, const SparseSystem& other);
  /// Returns A x.
  Eigen::VectorXd times(const Eigen::VectorXd& x) const { return lower_.selfadjointView<Eigen::Lower>() * x; }

  const Eigen::SparseMatrix<double>& lower() const { return lower_; }
  const Eigen::VectorXd& load() const { return load_; }
  /// Returns the norm of the absolute values of all parts of b: forces may cancel, and leave their round-off.
  double size_of_loads() const { return absolute_load_.norm(); }

 private:
  Eigen::SparseMatrix<double> lower_;
  Eigen::VectorXd load_;
  Eigen::VectorXd absolute_load_;
};

}  // namespace keyblock
