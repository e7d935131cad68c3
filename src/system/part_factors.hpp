// Factors of a large matrix whose functions fall into parts that do not couple, as bodies without contact: one a part.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "system/cholmod/sparse_factor.hpp"
#include "system/sparse_system.hpp"
#include "system/whole_system.hpp"

namespace keyblock {

class PartFactors {
 public:
  /// Each part lists its functions, ascending; every function is in one. Analyses the pattern of `system`, whose values
  /// do not matter.
  PartFactors(const SparseSystem& system, std::vector<std::vector<int>> parts, Definiteness definiteness);
  /// The same with parts that need not be symmetric, by LU: `is_whole` says which.
  PartFactors(const SparseSystem& system, const WholeSystem& whole, std::vector<std::vector<int>> parts,
              const std::vector<bool>& is_whole, Definiteness definiteness);

  int part_count() const { return static_cast<int>(parts_.size()); }
  std::span<const int> functions(int part) const { return parts_[static_cast<std::size_t>(part)].functions; }
  bool are_symmetric() const;

  /// Of all parts, those that need not be symmetric from `whole`. Throws NotPositiveDefinite, SingularMatrix.
  void factorise(const SparseSystem& system, const WholeSystem* whole = nullptr);

  /// A⁻¹ `right` within a part: rows 2i and 2i + 1 belong to the i-th of its functions.
  Eigen::MatrixXd solve(int part, const Eigen::MatrixXd& right) const;

  /// A⁻¹ `right` of all.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  struct Part {
    std::vector<int> functions;
    bool is_whole = false;
    Eigen::SparseMatrix<double> matrix;  // the lower triangle of a symmetric one
    std::unique_ptr<LinearFactor> factor;
  };
  std::vector<Part> parts_;
};

/// The unknowns of some functions, out of those of all.
Eigen::VectorXd unknowns_of(std::span<const int> functions, const Eigen::VectorXd& all);

}  // namespace keyblock
