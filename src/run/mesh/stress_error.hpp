// How far the stresses of a static solution on covers are from smoother ones: an estimate of its error.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "model/continuum.hpp"

namespace keyblock {

/// A disc in which errors do not count.
struct Uncounted {
  Point at;
  double radius = 0;
};

/// Squares of energy norms per unit thickness, F. Elements that carry near-tip functions count no error: no polynomial
/// can be fitted there.
struct StressError {
  std::vector<double> of_element;
  double total = 0;      ///< their sum
  double strain = 0;     ///< ∫ σ:ε of the solution where errors count: twice its energy, without initial stress
  double round_off = 0;  ///< what `strain` may be by round-off alone

  /// Of the energy norm of the exact solution, as estimated: √(e² / (u² + e²)) (Zienkiewicz & Zhu 1987); 0 where there
  /// is no strain but round-off.
  double share() const;
};

/// ‖e‖² = ∫ (σ* - σ):D⁻¹:(σ* - σ) dA, σ the stress of the displacement `d` and σ* that recovered from it (Zienkiewicz &
/// Zhu 1992): on the elements of each physical cover one polynomial of the degree of the displacement, fitted to the
/// stress by least squares, in an element the three of its covers joined by the weights of its triangle. Where the
/// elements of a cover tell too little, those around them are fitted too; where a body has too few, or no whole
/// triangle, all of its stress counts as wrong. Covers are of one body and end at joints and cracks, as do the fits.
StressError stress_error(const Continuum& continuum, const CoverBasis& basis, const Eigen::VectorXd& d,
                         std::span<const Uncounted> uncounted = {});

}  // namespace keyblock
