// Factorises a large matrix whose functions form uncoupled parts, such as bodies without contact: once per part.
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
  /// Analyses the pattern of `system`, whose values do not matter. Each part lists its functions, ascending; every
  /// function is in one part.
  PartFactors(const SparseSystem& system, std::vector<std::vector<int>> parts, Definiteness definiteness);
  /// Analyses parts of which some need not be symmetric and are factorised by LU; `is_whole` names these.
  PartFactors(const SparseSystem& system, const WholeSystem& whole, std::vector<std::vector<int>> parts,
              const std::vector<bool>& is_whole, Definiteness definiteness);

  int part_count() const { return static_cast<int>(parts_.size()); }
  std::span<const int> functions(int part) const { return parts_[static_cast<std::size_t>(part)].functions; }
  bool are_symmetric() const;

  /// Factorises all parts, those that need not be symmetric from `whole`. Throws NotPositiveDefinite, SingularMatrix.
  void factorise(const SparseSystem& system, const WholeSystem* whole = nullptr);

  /// Returns A⁻¹ `right` within a part: rows 2i and 2i + 1 belong to the i-th of its functions.
  Eigen::MatrixXd solve(int part, const Eigen::MatrixXd& right) const;

  /// Returns A⁻¹ `right` for all parts.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  struct Part {
    std::vector<int> functions;
    bool is_whole = false;
    Eigen::SparseMatrix<double> matrix;  // lower triangle of a symmetric matrix
    std::unique_ptr<LinearFactor> factor;
  };
  std::vector<Part> parts_;
};

/// Returns the unknowns of some functions, from those of all.
Eigen::VectorXd unknowns_of(std::span<const int> functions, const Eigen::VectorXd& all);

}  // namespace keyblock
