// Solves a symmetric block system by iterations, for steps whose inertia keeps neighbours nearly uncoupled.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "system/block_matrix.hpp"

namespace keyblock {

/// Where iterations end.
struct IterationLimits {
  double residual = 0;  ///< ‖b − A x‖ / ‖b‖ that is small enough
  int count = 0;        ///< iterations at most
};

struct IterationResult {
  Eigen::VectorXd x;
  int iterations = 0;
  double residual =
      std::numeric_limits<double>::infinity();  ///< ‖b − A x‖ / ‖b‖ of this x, in double; infinite: not looked at
  bool converged = false;
};

/// Conjugate gradients (Hestenes & Stiefel 1952) from `start`, preconditioned by the incomplete block factor L D Lᵀ on
/// the pattern of A (Meijerink & van der Vorst 1977). A: symmetric positive definite, blocks of up to 6 rows, all
/// padded to one size (2, 3 or 6). Where a pivot is not positive the diagonal is raised by 1e-3 of itself, and by twice
/// as much in every further attempt (Manteuffel 1980). All in single precision but x and the residual that it is
/// corrected by, formed anew after every two figures (reliable updates: Sleijpen & van der Vorst 1996). Also converged
/// where the residual stays within ten times the goal and a correction no longer halves it. Not converged: x is the
/// best that was found.
IterationResult conjugate_gradients(const BlockMatrix& matrix, const Eigen::VectorXd& b, const Eigen::VectorXd& start,
                                    const IterationLimits& limits);

/// Successive over-relaxation block by block, as the old programs did it, with their factor 1 < ω < 2 (Young 1954).
IterationResult over_relaxation(const BlockMatrix& matrix, const Eigen::VectorXd& b, const Eigen::VectorXd& start,
                                double omega, const IterationLimits& limits);

}  // namespace keyblock
