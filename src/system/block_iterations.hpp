// Solves a symmetric block system by iterations, for steps whose inertia leaves neighbours nearly uncoupled.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "system/block_matrix.hpp"

namespace keyblock {

/// Limits at which iterations end.
struct IterationLimits {
  double residual = 0;  ///< target of ‖b − A x‖ / ‖b‖
  int count = 0;        ///< largest number of iterations
};

struct IterationResult {
  Eigen::VectorXd x;
  int iterations = 0;
  double residual =
      std::numeric_limits<double>::infinity();  ///< ‖b − A x‖ / ‖b‖ of this x, in double; infinite: not computed
  bool converged = false;
};

/// Solves by conjugate gradients (Hestenes & Stiefel 1952) from `start`. The preconditioner is the incomplete block
/// factorisation L D Lᵀ on the pattern of A (Meijerink & van der Vorst 1977).
///
/// A must be symmetric positive definite, with blocks of up to 6 rows, all padded to one size (2, 3 or 6). If a pivot
/// is not positive, the diagonal is raised by 1e-3 of itself, and by twice as much in every further attempt (Manteuffel
/// 1980). All is in single precision except x and its residual, which is recomputed after every two digits (reliable
/// updates: Sleijpen & van der Vorst 1996).
///
/// A solve has also converged if the residual stays within ten times the target and a correction no longer halves it.
/// If it has not converged, x is the best one found.
IterationResult conjugate_gradients(const BlockMatrix& matrix, const Eigen::VectorXd& b, const Eigen::VectorXd& start,
                                    const IterationLimits& limits);

/// Solves by successive over-relaxation, block by block, as in Shi's programs, with their factor 1 < ω < 2 (Young
/// 1954).
IterationResult over_relaxation(const BlockMatrix& matrix, const Eigen::VectorXd& b, const Eigen::VectorXd& start,
                                double omega, const IterationLimits& limits);

}  // namespace keyblock
