// The ways to solve the symmetric system of a pass.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace keyblock {

enum class LinearMethod {
  automatic,  ///< gradients where inertia rules and blocks are many, as `Solver` says; else the factor
  factor,
  conjugate_gradients,
  /// of the old programs, which did not look at its residual; here one above 1e-11 after 3,000 sweeps ends the run
  over_relaxation,
};

}  // namespace keyblock
