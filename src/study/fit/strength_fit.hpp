// Fits the cohesion and friction of Mohr and Coulomb to strengths under several confining pressures.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "study/fit/measured.hpp"

namespace keyblock::study {

/// Fit of σ1 = N σ3 + q at failure, compression positive, N = (1 + sin φ)/(1 - sin φ), q = 2 c √N.
struct StrengthFit {
  Found ratio;                 ///< N
  Found compressive_strength;  ///< q
  Found cohesion;
  Found friction_deg;
  Agreement agreement;
};

/// Fits σ1 (`y`) over σ3 (`x`) by linear least squares; errors of c and φ follow from those of N and q to first order.
/// Throws InputError for fewer than 2 tests, a single pressure, σ1 below σ3, or a line without valid cohesion and
/// friction.
StrengthFit fit_strength(const MeasuredPairs& tests);

}  // namespace keyblock::study
