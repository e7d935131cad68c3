// Evaluates the field near a crack tip in an elastic body, scaled by its stress intensity factors.
// Theory: docs/theory/10-fracture.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "problem/analysis.hpp"

namespace keyblock {

/// Elastic constants of a plane problem.
struct PlaneElasticity {
  double youngs_modulus = 0;  ///< F/L²
  double poissons_ratio = 0;
  bool is_plane_strain = false;

  double shear_modulus() const { return youngs_modulus / (2 * (1 + poissons_ratio)); }
  /// Returns E', with J = (K_I² + K_II²) / E': E, under plane strain E / (1 - ν²).
  double effective_modulus() const;
  /// Returns Kolosov's constant κ: (3 - ν)/(1 + ν), under plane strain 3 - 4ν.
  double kolosov() const;
};

/// Stress intensity factors of a tip in both modes, F/L^1.5.
struct StressIntensity {
  double mode_1 = 0;
  double mode_2 = 0;
};

/// Share of K by which two good treatments of a tip may differ, and below which a factor is noise.
inline constexpr double kNoiseOfFactors = 0.03;

/// Returns true if K_I is negative by more than noise: the faces overlap at the tip, because no contact separates them.
bool faces_overlap(const StressIntensity& k);

/// Returns G = (K_I² + K_II²)/E' of a tip that propagates straight ahead (Irwin 1957) [F/L].
double energy_release(const PlaneElasticity& rock, const StressIntensity& k);

/// Returns ∂u_i/∂x_j, 2 × 2, at a distance r > 0 and the angle θ (Williams 1957; Irwin 1957; Moran & Shih 1987). θ is
/// counted from straight ahead [rad, -π to π]. The axes are those of the tip: x ahead, y to its left.
Eigen::Matrix2d near_tip_gradient(const PlaneElasticity& rock, const StressIntensity& k, double r, double theta);

/// Returns (σxx, σyy, σxy) of the field.
Eigen::Vector3d near_tip_stress(const StressIntensity& k, double r, double theta);

}  // namespace keyblock
