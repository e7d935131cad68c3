// Estimates the error of a static NMM solution from the difference between its stresses and smoother ones. Theory:
// docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "model/continuum.hpp"

namespace keyblock {

/// Disc in which errors do not count.
struct Uncounted {
  Point at;
  double radius = 0;
};

/// Squares of energy norms per unit thickness, F. Elements with near-tip functions count no error: no polynomial fits
/// there.
struct StressError {
  std::vector<double> of_element;
  double total = 0;      ///< their sum
  double strain = 0;     ///< ∫ σ:ε where errors count: twice the energy of the solution, without initial stress
  double round_off = 0;  ///< part of `strain` by round-off alone

  /// Returns the estimated error relative to the energy norm of the exact solution: √(e² / (u² + e²)) (Zienkiewicz &
  /// Zhu 1987). The result is 0 if all strain is round-off.
  double share() const;
};

/// Returns ‖e‖² = ∫ (σ* - σ):D⁻¹:(σ* - σ) dA, with σ the stress of the displacement `d` and σ* the recovered stress
/// (Zienkiewicz & Zhu 1992). Each physical cover has one polynomial of the degree of the displacement, fitted by least
/// squares to the stress of its elements. In an element the weights of its triangle blend the three polynomials of its
/// covers. If the elements of a cover are too few, elements around them join the fit. If a body has too few, or no
/// whole triangle, all of its stress counts as error. Covers, and so the fits, belong to one body and end at joints and
/// cracks.
StressError stress_error(const Continuum& continuum, const CoverBasis& basis, const Eigen::VectorXd& d,
                         std::span<const Uncounted> uncounted = {});

}  // namespace keyblock
