// Elastic rock with cracks that compression closes: energy, stress and stiffness, without memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <string>

#include "problem/yield.hpp"

namespace keyblock {

/// Intact rock in series with a crack strain w along each principal direction of stress:
/// W(ε) = min over w of ½ (ε - w) · D (ε - w) + ½ k w · w, 1/k = 1/E1 - 1/E2, w_i ≥ -ε_c (1 - E1/E2), with D of E2.
/// Convex and isotropic: the energy of a strain is one, whatever the way to it. Under uniaxial stress the bilinear
/// curve E1 ε to the closure strain ε_c, E1 ε_c + E2 (ε - ε_c) beyond; tension has E1. What cracks add has no lateral
/// strain.
struct CrackedElasticity {
  double youngs_modulus = 0;  ///< E2
  double poissons_ratio = 0;
  CrackClosure closure;

  /// 1/k.
  double compliance() const { return 1 / closure.initial_modulus - 1 / youngs_modulus; }
  /// Principal stress (negative) at which the crack across it closes.
  double closing_stress() const { return -closure.initial_modulus * closure.closure_strain; }
  /// Crack strain of a principal stress: σ/k, no less than that of a closed crack.
  double crack_strain(double stress) const { return compliance() * std::max(stress, closing_stress()); }
  bool is_closed(double stress) const { return stress <= closing_stress(); }
};

/// Of two or three principal axes.
using OfAxes = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;
using ByAxes = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;

/// The state in principal axes, in the order of the strains; of two axes under plane stress.
struct CrackedState {
  OfAxes stress;
  OfAxes cracks;      ///< w
  ByAxes stiffness;   ///< ∂stress/∂strain in fixed axes
  double stored = 0;  ///< W
  int closed = 0;     ///< how many cracks are
};

/// Of principal strains, 3, or the 2 in the plane where no stress acts across it. The cracks that are closed are those
/// of the most compressed axes, so that at most four sets are tried, each linear.
CrackedState cracked_state(const CrackedElasticity& rock, const OfAxes& strain);

/// What rock answers to a strain (xx, yy, 2xy, zz); stress as (xx, yy, xy, zz).
struct CrackedResponse {
  Eigen::Vector4d strain = Eigen::Vector4d::Zero();  ///< as given; under plane stress with the zz that goes with it
  Eigen::Vector4d stress = Eigen::Vector4d::Zero();
  Eigen::Matrix4d tangent = Eigen::Matrix4d::Zero();  ///< ∂stress/∂strain; row and column of zz are 0 in plane stress
  double stored = 0;
  int closed = 0;    ///< cracks that are closed
  int possible = 3;  ///< cracks that may be: 2 where no stress acts across the plane
};
CrackedResponse cracked_response(const CrackedElasticity& rock, const Eigen::Vector4d& strain, bool is_plane_stress);

/// Empty, or why no run can be made of it.
std::string why_unusable(const CrackClosure& closure, double youngs_modulus);

}  // namespace keyblock
