// Solves a symmetric block system by a factorisation or by iterations, and recomputes the true residual.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "system/block_factor.hpp"
#include "system/block_matrix.hpp"
#include "system/linear_method.hpp"

namespace keyblock {

struct Solution {
  Eigen::VectorXd x;
  double residual = 0;  ///< ‖b − A x‖ / ‖b‖, recomputed from the block matrix
};

/// Properties of a linear system that are known beforehand.
struct SystemKind {
  /// R = p Δt² / 2m, contact stiffness over inertia of an average block; infinite without inertia.
  double stiffness_over_inertia = std::numeric_limits<double>::infinity();
  Eigen::VectorXd guess{};  ///< of the solution; empty: zero
};

/// Solves linear systems and keeps the symbolic factorisation, and its memory, while the pattern stays the same.
///
/// The factorisation is always that of blocks, because CHOLMOD was not faster. `automatic` uses conjugate gradients for
/// 300 blocks and more if R ≤ 400. If they fail once to converge at the cost of a factorisation (100 iterations; from
/// 4,000 blocks 250), the factorisation is used from there on. Systems of covers follow the same rule.
class Solver {
 public:
  /// Returns nothing if the factorisation fails or the result is not finite. The target of conjugate gradients is
  /// 1e-13, or 1e-12 if they gain no more; otherwise the factorisation is used. Over-relaxation that does not reach
  /// 1e-13 returns nothing.
  std::optional<Solution> solve(const System& system, const SystemKind& kind = {});

  LinearMethod method = LinearMethod::automatic;
  /// True after iterations missed their target; `automatic` does not try them again, nor does a resumed run.
  bool gave_up_iterations = false;

 private:
  bool iterates(int block_count, double stiffness_over_inertia) const;
  std::unique_ptr<BlockFactor> factor_of(const BlockMatrix& matrix, MatrixShape shape);
  std::optional<Eigen::VectorXd> by_factor(const System& system);
  std::optional<Solution> by_iterations(const System& system, const Eigen::VectorXd& guess) const;

  FactorStore factors_;
};

}  // namespace keyblock
