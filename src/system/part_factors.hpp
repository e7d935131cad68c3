// Factors of a large symmetric matrix whose functions fall into parts that do not couple, as bodies without contact:
// one a part.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "system/sparse_factor.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

class PartFactors {
 public:
  /// Each part lists its functions, ascending; every function is in one. Analyses the pattern of `system`, whose values
  /// do not matter.
  PartFactors(const SparseSystem& system, std::vector<std::vector<int>> parts, Definiteness definiteness);

  int part_count() const { return static_cast<int>(parts_.size()); }
  std::span<const int> functions(int part) const { return parts_[static_cast<std::size_t>(part)]; }

  /// Of all parts. Throws NotPositiveDefinite.
  void factorise(const SparseSystem& system);

  /// A⁻¹ `right` within a part: rows 2i and 2i + 1 belong to the i-th of its functions.
  Eigen::MatrixXd solve(int part, const Eigen::MatrixXd& right) const;

  /// A⁻¹ `right` of all.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  std::vector<std::vector<int>> parts_;
  std::vector<Eigen::SparseMatrix<double>> lower_;
  std::vector<SparseFactor> factors_;
};

/// The unknowns of some functions, out of those of all.
Eigen::VectorXd unknowns_of(std::span<const int> functions, const Eigen::VectorXd& all);

}  // namespace keyblock
