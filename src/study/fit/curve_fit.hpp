// Fits the bilinear elastoplastic curve of uniaxial compression to a measured one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "study/fit/measured.hpp"

namespace keyblock::study {

/// Curve σ = E1 ε up to the closure strain, E1 ε_c + E2 (ε - ε_c) beyond, at most the strength; compression positive.
struct BilinearCurve {
  double initial_modulus = 0;
  double youngs_modulus = 0;
  double closure_strain = 0;
  double strength = 0;

  double stress(double strain) const;
};

/// Parameters of a measured curve. Without closure there is one modulus, without a plateau no strength.
struct CurveFit {
  Found youngs_modulus;
  std::optional<Found> initial_modulus;
  std::optional<Found> closure_strain;
  std::optional<Found> strength;
  Agreement agreement;
  bool is_turned = false;  ///< compression was negative in the file
};

enum class CompressionSign { found, positive, negative };

/// Fits by least squares of stress. Four kinds of curve are tried, with or without closure and plateau; a break has at
/// least two points on either side. The least criterion of Schwarz (1978) selects among them. Each kind starts from the
/// best of a grid of breaks, for which the rest is linear. GSL's trust region of Levenberg and Marquardt follows.
/// Standard errors come from the final Jacobian. Throws InputError for fewer than 8 points, strains that do not
/// increase, stress and strain of opposite signs, or a curve that does not rise.
CurveFit fit_curve(MeasuredPairs curve, CompressionSign sign);

}  // namespace keyblock::study
