// How far the stresses of a static solution on covers are from smoother ones: an estimate of its error.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/continuum.hpp"

namespace keyblock {

/// Squares of energy norms per unit thickness, F. Of elements whose functions are no polynomials the error is 0: near a
/// tip, recovered stresses are none.
struct StressError {
  std::vector<double> of_element;
  double total = 0;   ///< their sum
  double strain = 0;  ///< ∫ σ:ε of the solution, twice its strain energy; the initial stress does no part of it

  /// Of the energy norm of the exact solution, as estimated: √(e² / (u² + e²)) (Zienkiewicz & Zhu 1987).
  double share() const;
};

/// ‖e‖² = ∫ (σ* - σ):D⁻¹:(σ* - σ) dA, σ the stress of the displacement `d` and σ* that recovered from it (Zienkiewicz &
/// Zhu 1992): on the elements of each physical cover one polynomial of the degree of the displacement, fitted to the
/// stress by least squares, in an element the three of its covers joined by the weights of its triangle. Covers are of
/// one body and end at joints and cracks, and so do the fits.
StressError stress_error(const Continuum& continuum, const CoverBasis& basis, const Eigen::VectorXd& d);

}  // namespace keyblock
