// Return of a trial stress to a yield surface in principal axes, in closed form, with derivatives.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "problem/yield.hpp"

namespace keyblock {

/// Where on its surface a point lies.
enum class YieldRegion { elastic, plane, edge, apex, tension };

/// A cone √J2 + slope I1 = strength.
struct Cone {
  double slope = 0;
  double strength = 0;
};

/// The cone of a cohesion and an angle: of triaxial compression 2 sin φ / (√3 (3 - sin φ)), 6 c cos φ / (√3 (3 - sin
/// φ)), of extension with + for - (Drucker & Prager 1952; Chen 1975), of plane strain tan φ / √(9 + 12 tan² φ), 3 c
/// over the same root, which is the inscribed one too (ibid.).
Cone cone_of(ConeMatching matching, double cohesion, double friction_deg);

/// A strength that changes linearly in κ from 0 to `strain`.
struct SurfaceOfKappa {
  const Strength& strength;
  double strain;  ///< of the end of the change; infinity: none
};

/// A stress in principal axes, greatest first, and how it follows the trial stress and κ.
struct PrincipalReturn {
  Eigen::Vector3d stress;
  Eigen::Matrix3d by_trial;
  Eigen::Vector3d by_kappa;
  YieldRegion region = YieldRegion::elastic;
};

/// Stress on the surface at κ that a trial stress (greatest first, tension positive) returns to along the flow,
/// Δσ = -D Σ x_i b_i with x ≥ 0, or the trial itself where it lies inside. `elasticity`: D in principal axes, of an
/// isotropic material for cones.
///
/// Tresca and Mohr-Coulomb: k σ1 - σ3 ≤ f_c with k = (1 + sin φ)/(1 - sin φ), f_c = 2 c √k, flow likewise with ψ;
/// planes, edges and apex tried in turn (Clausen, Damkilde & Andersen 2006, 2007; de Souza Neto, Perić & Owen 2008,
/// ch. 8), and σi ≤ T with associated flow. Von Mises: radial (Simo & Hughes 1998, box 3.1). Drucker-Prager: cone,
/// apex, and a limit of the mean stress (de Souza Neto et al., ch. 8). On the surface to rounding of max(|σ|, f_c)
/// whatever the trial is.
PrincipalReturn return_to_surface(const SurfaceOfKappa& surface, double kappa, const Eigen::Vector3d& trial,
                                  const Eigen::Matrix3d& elasticity);

/// Its stress alone.
Eigen::Vector3d stress_on_surface(const SurfaceOfKappa& surface, double kappa, const Eigen::Vector3d& trial,
                                  const Eigen::Matrix3d& elasticity);

/// By how much a stress (greatest first) lies outside of the surface at κ, in units of stress; at most 0 inside.
double excess_of_stress(const SurfaceOfKappa& surface, double kappa, const Eigen::Vector3d& stress);

/// A stress of the surface's size: its compressive strength at κ; the scale of what counts as outside.
double surface_scale(const SurfaceOfKappa& surface, double kappa);

}  // namespace keyblock
