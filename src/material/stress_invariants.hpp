// Computes invariants of stress: mean, von Mises stress and Lode angle.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/analysis.hpp"

namespace keyblock {

/// Invariants with s the deviator, J2 = s : s / 2 and J3 = det s. Tension positive.
struct StressInvariants {
  double mean = 0;       ///< (xx + yy + zz) / 3, force / length²
  double von_mises = 0;  ///< q = √(3 J2), the yield stress in uniaxial tension (von Mises 1913), force / length²
  /// θ = arcsin(-(3√3/2) J3 / J2^(3/2)) / 3 [degree] (Nayak & Zienkiewicz 1972): -30 in triaxial extension (σ1 > σ2 =
  /// σ3), 0 in pure shear, 30 in triaxial compression; 0 without a deviator.
  double lode_deg = 0;
};

StressInvariants invariants_of(const Stress& stress);

}  // namespace keyblock
