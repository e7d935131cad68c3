// One call that solves a symmetric block system, by a factor or by iterations, and says how well: the true residual is
// recomputed.
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

/// What is known of a system beforehand.
struct SystemKind {
  /// R = p Δt² / 2m, contact stiffness over inertia of a mean block; infinite without inertia.
  double stiffness_over_inertia = std::numeric_limits<double>::infinity();
  Eigen::VectorXd guess{};  ///< of the solution; empty: zero
};

/// Keeps the symbolic factor, and the room of the last one, while the pattern stays the same. The factor is always the
/// block factor: CHOLMOD gained nothing beside it. `automatic`: conjugate gradients for 300 blocks and more where
/// R ≤ 400, until they once fail to converge in what costs as much as a factor (100 iterations; from 4,000 blocks 250);
/// then the factor from there on. Systems of covers go by the same rule.
class Solver {
 public:
  /// Nothing if the factorisation breaks down or the result is not finite. Gradients are to reach 1e-11, or 1e-10 where
  /// they gain no more; what they do not reach is left to the factor. Over-relaxation that does not reach 1e-11 has no
  /// solution.
  std::optional<Solution> solve(const System& system, const SystemKind& kind = {});

  LinearMethod method = LinearMethod::automatic;
  /// Iterations missed their goal once; `automatic` does not try them again, nor does a run that is resumed.
  bool gave_up_iterations = false;

 private:
  bool iterates(int block_count, double stiffness_over_inertia) const;
  std::unique_ptr<BlockFactor> factor_of(const BlockMatrix& matrix, MatrixShape shape);
  std::optional<Eigen::VectorXd> by_factor(const System& system);
  std::optional<Solution> by_iterations(const System& system, const Eigen::VectorXd& guess) const;

  FactorStore factors_;
};

}  // namespace keyblock
