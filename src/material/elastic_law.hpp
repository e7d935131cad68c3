// Computes stress, stored energy and stiffness of a point under large strain from its Green strain.
// Theory: docs/theory/02-equations-of-motion.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "settings/settings.hpp"

namespace keyblock {

/// Law T = T0 + D ε of a strain measure ε, (11, 22, 2·12).
///
/// The measure is the Green strain E = ½ (C - I) (St. Venant–Kirchhoff), or ½ ln C in the axes of the undeformed body
/// (Hencky; Miehe, Apel & Lambrecht 2002). Under the latter the force of a compressed bar grows without limit. Under
/// plane stress D is that of plane stress: both laws then give no stress across the plane. Pure functions; returned
/// stresses are second Piola–Kirchhoff, S = Pᵀ T with P = ∂ε/∂E.
struct ElasticPoint {
  ElasticLaw law;
  const Eigen::Matrix3d& modulus;             ///< D, 3 × 3
  Eigen::Map<const Eigen::Vector3d> initial;  ///< T0: xx, yy, xy; a view, as that of D

  /// Returns T0 · ε + ½ ε · D ε, per undeformed area.
  double energy(const Eigen::Vector3d& green) const;

  /// Returns T at a strain.
  Eigen::Vector3d stress_of_measure(const Eigen::Vector3d& green) const;

  /// Returns S at a strain.
  Eigen::Vector3d stress(const Eigen::Vector3d& green) const;

  /// Returns S of a step from E0 to E1 whose work S · (E1 - E0) is T_θ · (ε1 - ε0), T_θ = T0 + D (ε0 + θ (ε1 - ε0)).
  /// For θ = ½ the work is the change of energy (Simo & Tarnow 1992; for logarithms with Gonzalez' correction along E1
  /// - E0, 2000).
  Eigen::Vector3d stress_of_step(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double theta) const {
    if (law != ElasticLaw::st_venant_kirchhoff) return log_stress_of_step(from, to, theta);
    const Eigen::Vector3d strain = (1 - theta) * from + theta * to;
    return initial + modulus * strain;
  }

  /// Returns ∂S/∂E, the second derivative of the energy.
  Eigen::Matrix3d stiffness(const Eigen::Vector3d& green) const;

  /// Returns ∂S/∂E1 of a step over θ > 0, symmetric; for logarithms terms of the order of the step are left out.
  Eigen::Matrix3d stiffness_of_step(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double theta) const {
    return law == ElasticLaw::st_venant_kirchhoff ? modulus : log_stiffness_of_step(from, to, theta);
  }

 private:
  /// Returns T_θ between two strains of the measure.
  Eigen::Vector3d mean_stress(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double theta) const {
    const Eigen::Vector3d strain = (1 - theta) * from + theta * to;
    return initial + modulus * strain;
  }
  Eigen::Vector3d log_stress_of_step(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double theta) const;
  Eigen::Matrix3d log_stiffness_of_step(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double theta) const;
};

/// Returns ½ ln C of C = I + 2 E as (11, 22, 2·12). Exact to the last digits at small strain too.
Eigen::Vector3d log_strain(const Eigen::Vector3d& green);

/// Returns P = ∂(½ ln C)/∂E, 3 × 3.
Eigen::Matrix3d log_strain_rate(const Eigen::Vector3d& green);

/// Returns ∂(Pᵀ T)/∂E at fixed T, 3 × 3 symmetric.
Eigen::Matrix3d log_strain_curvature(const Eigen::Vector3d& green, const Eigen::Vector3d& stress);

/// Returns S of a step from E0 to E1 whose work S · (E1 - E0) is `mean` · (ε1 - ε0), ε = ½ ln C. `mean` is a stress
/// conjugate to ε. S is Pᵀ T at the mean of both strains, corrected along E1 - E0 (Gonzalez 2000).
Eigen::Vector3d log_step_stress(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& mean);

/// Returns ∂S/∂E1 of `log_step_stress`, 3 × 3, exact and not symmetric. `by_end`: ∂`mean`/∂ε1.
Eigen::Matrix3d log_step_stiffness(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& mean,
                                   const Eigen::Matrix3d& by_end);

inline double ElasticPoint::energy(const Eigen::Vector3d& green) const {
  const auto stored = [&](const Eigen::Vector3d& strain) { return strain.dot(initial + modulus * strain / 2); };
  return law == ElasticLaw::st_venant_kirchhoff ? stored(green) : stored(log_strain(green));
}

inline Eigen::Vector3d ElasticPoint::stress_of_measure(const Eigen::Vector3d& green) const {
  return initial + modulus * (law == ElasticLaw::st_venant_kirchhoff ? green : log_strain(green));
}

inline Eigen::Vector3d ElasticPoint::stress(const Eigen::Vector3d& green) const {
  if (law == ElasticLaw::st_venant_kirchhoff) return initial + modulus * green;
  return log_strain_rate(green).transpose() * stress_of_measure(green);
}

}  // namespace keyblock
