// Computes energy, stress and stiffness of elastic rock whose cracks close under compression, without memory.
// Theory: docs/theory/09-plasticity.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <string>

#include "problem/yield.hpp"

namespace keyblock {

/// Intact rock in series with a crack strain w along each principal direction of stress:
///   W(ε) = min over w of ½ (ε - w) · D (ε - w) + ½ k w · w, 1/k = 1/E1 - 1/E2, w_i ≥ -ε_c (1 - E1/E2), with D of E2.
/// Convex and isotropic: the energy of a strain does not depend on the path. Under uniaxial compression the
/// stress–strain curve is bilinear: E1 ε to the closure strain ε_c, E1 ε_c + E2 (ε - ε_c) beyond. Tension has E1. Crack
/// strain has no lateral part.
struct CrackedElasticity {
  double youngs_modulus = 0;  ///< E2
  double poissons_ratio = 0;
  CrackClosure closure;

  /// Returns 1/k.
  double compliance() const { return 1 / closure.initial_modulus - 1 / youngs_modulus; }
  /// Returns the principal stress (negative) at which the crack across it closes.
  double closing_stress() const { return -closure.initial_modulus * closure.closure_strain; }
  /// Returns the crack strain of a principal stress: σ/k, no less than that of a closed crack.
  double crack_strain(double stress) const { return compliance() * std::max(stress, closing_stress()); }
  bool is_closed(double stress) const { return stress <= closing_stress(); }
};

/// Values along two or three principal axes.
using OfAxes = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;
using ByAxes = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;

/// State in principal axes, in the order of the strains; plane stress has two axes.
struct CrackedState {
  OfAxes stress;
  OfAxes cracks;      ///< w
  ByAxes stiffness;   ///< ∂stress/∂strain in fixed axes
  double stored = 0;  ///< W
  int closed = 0;     ///< number of closed cracks
};

/// Returns the state at principal strains: 3, or the 2 in the plane if there is no stress across it. Closed cracks are
/// those of the most compressed axes, so that at most four sets are tried, each linear.
CrackedState cracked_state(const CrackedElasticity& rock, const OfAxes& strain);

/// Response of rock to a strain (xx, yy, 2xy, zz); stress as (xx, yy, xy, zz).
struct CrackedResponse {
  Eigen::Vector4d strain = Eigen::Vector4d::Zero();  ///< as given; under plane stress with its zz
  Eigen::Vector4d stress = Eigen::Vector4d::Zero();
  Eigen::Matrix4d tangent = Eigen::Matrix4d::Zero();  ///< ∂stress/∂strain; row and column of zz are 0 in plane stress
  double stored = 0;
  int closed = 0;    ///< number of closed cracks
  int possible = 3;  ///< cracks that can close: 2 without stress across the plane
};
CrackedResponse cracked_response(const CrackedElasticity& rock, const Eigen::Vector4d& strain, bool is_plane_stress);

/// Returns an empty string, or the reason why a run cannot use the closure.
std::string why_unusable(const CrackClosure& closure, double youngs_modulus);

}  // namespace keyblock
