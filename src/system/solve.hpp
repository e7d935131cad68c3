// One call that solves a symmetric block system and says how well: the true residual is always recomputed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCholesky>
#include <memory>
#include <optional>

#include "system/block_matrix.hpp"

namespace keyblock {

struct Solution {
  Eigen::VectorXd x;
  double residual = 0;  ///< ‖b − A x‖ / ‖b‖, recomputed from the block matrix
};

/// Sparse L D Lᵀ (Eigen, approximate minimum degree). Keeps the symbolic factor while the pattern stays the
/// same.
class Solver {
 public:
  /// Nothing if the factorisation breaks down or the result is not finite.
  std::optional<Solution> solve(const System& system);

 private:
  using Sparse = Eigen::SparseMatrix<double>;
  using Factor = Eigen::SimplicialLDLT<Sparse, Eigen::Lower>;
  bool same_pattern(const Sparse& matrix) const;

  Sparse matrix_;
  std::unique_ptr<Factor> factor_ = std::make_unique<Factor>();
};

}  // namespace keyblock
