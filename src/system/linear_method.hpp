// Lists the methods for the symmetric linear solve of an iteration.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace keyblock {

enum class LinearMethod {
  automatic,  ///< conjugate gradients if inertia dominates and blocks are many, as in `Solver`; else the factorisation
  factor,
  conjugate_gradients,
  /// Method of Shi's programs, which did not test its residual; here one above 1e-13 after 3,000 sweeps ends the run.
  over_relaxation,
};

}  // namespace keyblock
