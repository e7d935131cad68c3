// The field that every crack tip in an elastic body has near it, scaled by its stress intensity factors.
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
  /// E', by which J = (K_I² + K_II²) / E': E, under plane strain E / (1 - ν²).
  double effective_modulus() const;
  /// Kolosov's constant κ: (3 - ν)/(1 + ν), under plane strain 3 - 4ν.
  double kolosov() const;
};

/// What a tip has by the two modes; F/L^1.5.
struct StressIntensity {
  double mode_1 = 0;
  double mode_2 = 0;
};

/// Share of K by which two good treatments of a tip may differ, and below which a factor is noise.
inline constexpr double kNoiseOfFactors = 0.03;

/// K_I below 0 by more than noise: the faces lie in one another at the tip, for nothing holds them apart.
bool faces_overlap(const StressIntensity& k);

/// G = (K_I² + K_II²)/E' of a tip that goes straight on (Irwin 1957); F/L.
double energy_release(const PlaneElasticity& rock, const StressIntensity& k);

/// ∂u_i/∂x_j, 2 × 2, at a distance r > 0 and the angle θ (rad, -π to π, from straight ahead) in the axes of the tip: x
/// ahead, y to its left (Williams 1957; Irwin 1957; Moran & Shih 1987).
Eigen::Matrix2d near_tip_gradient(const PlaneElasticity& rock, const StressIntensity& k, double r, double theta);

/// (σxx, σyy, σxy) of the same.
Eigen::Vector3d near_tip_stress(const StressIntensity& k, double r, double theta);

/// (ux, uy) of the same, 0 at the tip.
Eigen::Vector2d near_tip_displacement(const PlaneElasticity& rock, const StressIntensity& k, double r, double theta);

}  // namespace keyblock
