// The bilinear elasto-plastic curve of uniaxial compression, fitted to a measured one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "study/fit/measured.hpp"

namespace keyblock::study {

/// σ = E1 ε up to the closure strain, E1 ε_c + E2 (ε - ε_c) beyond, no more than the strength; compression positive.
struct BilinearCurve {
  double initial_modulus = 0;
  double youngs_modulus = 0;
  double closure_strain = 0;
  double strength = 0;

  double stress(double strain) const;
};

/// What a measured curve shows. Without closure there is one modulus, without a plateau no strength.
struct CurveFit {
  Found youngs_modulus;
  std::optional<Found> initial_modulus;
  std::optional<Found> closure_strain;
  std::optional<Found> strength;
  Agreement agreement;
  bool is_turned = false;  ///< compression was negative in the file
};

enum class CompressionSign { found, positive, negative };

/// Least squares of stress. Whether the curve shows closure, and a plateau, is told by the least criterion of Schwarz
/// (1978) among the four kinds of curve; a break has at least two points
/// on either side. The start of each kind is the best of a grid of breaks, for which the rest is linear; then GSL's
/// trust region of Levenberg and Marquardt. Standard errors from the Jacobian at the end. Throws InputError for fewer
/// than 8 points, strains that do not increase, stress and strain of opposite signs, or a curve that does not rise.
CurveFit fit_curve(MeasuredPairs curve, CompressionSign sign);

}  // namespace keyblock::study
