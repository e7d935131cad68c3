// Returns a trial stress to a yield surface in principal axes, in closed form, with derivatives.
// Theory: docs/theory/09-plasticity.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "material/principal/surface_of_kappa.hpp"
#include "problem/yield.hpp"

namespace keyblock {

/// Part of the surface on which a point lies.
enum class YieldRegion { elastic, plane, edge, apex, tension };

/// Cone √J2 + slope I1 = strength.
struct Cone {
  double slope = 0;
  double strength = 0;
};

/// Returns the cone of a cohesion c and a friction angle φ (Drucker & Prager 1952; Chen 1975). Triaxial compression has
/// slope 2 sin φ / (√3 (3 - sin φ)) and strength 6 c cos φ / (√3 (3 - sin φ)); extension has + for -. Plane strain has
/// tan φ / √(9 + 12 tan² φ) and 3 c over the same root, which is the inscribed cone too (ibid.).
Cone cone_of(ConeMatching matching, double cohesion, double friction_deg);

/// Stress in principal axes, greatest first, with its derivatives by the trial stress and κ.
struct PrincipalReturn {
  Eigen::Vector3d stress;
  Eigen::Matrix3d by_trial;
  Eigen::Vector3d by_kappa;
  YieldRegion region = YieldRegion::elastic;
};

/// Returns the stress on the surface at κ to which a trial stress (greatest first, tension positive) returns along the
/// flow, Δσ = -D Σ x_i b_i with x ≥ 0. A trial stress inside is returned unchanged. `elasticity`: D in principal axes,
/// isotropic for cones.
///
/// Tresca and Mohr–Coulomb: k σ1 - σ3 ≤ f_c with k = (1 + sin φ)/(1 - sin φ), f_c = 2 c √k; flow has ψ for φ. Planes,
/// edges and apex are tried in turn (Clausen, Damkilde & Andersen 2006, 2007; de Souza Neto, Perić & Owen 2008, ch. 8).
/// Tension σi ≤ T has associated flow. Von Mises: radial (Simo & Hughes 1998, box 3.1). Drucker–Prager: cone, apex, and
/// a limit of the mean stress (de Souza Neto et al., ch. 8). The result is on the surface up to rounding of max(|σ|,
/// f_c) for every trial stress.
PrincipalReturn return_to_surface(const SurfaceOfKappa& surface, double kappa, const Eigen::Vector3d& trial,
                                  const Eigen::Matrix3d& elasticity);

/// Returns only the stress of `return_to_surface`.
Eigen::Vector3d stress_on_surface(const SurfaceOfKappa& surface, double kappa, const Eigen::Vector3d& trial,
                                  const Eigen::Matrix3d& elasticity);

/// Returns by how much a stress (greatest first) lies outside the surface at κ [stress]; at most 0 inside.
double excess_of_stress(const SurfaceOfKappa& surface, double kappa, const Eigen::Vector3d& stress);

/// Returns the compressive strength at κ, the scale for the excess of a stress.
double surface_scale(const SurfaceOfKappa& surface, double kappa);

}  // namespace keyblock
