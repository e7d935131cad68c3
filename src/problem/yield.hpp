// Holds properties of a material beyond linear elasticity: its cracks, yield surface, flow and toughness.
// Theory: docs/theory/09-plasticity.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace keyblock {

enum class YieldSurface { tresca, von_mises, mohr_coulomb, drucker_prager };

/// Edges on which the cone of Drucker and Prager touches the surface of Mohr and Coulomb with the same cohesion and
/// friction. They are its edges of triaxial compression (from outside), those of triaxial extension, or its faces (from
/// inside), as for plane strain with associated flow.
enum class ConeMatching { compression, extension, plane_strain };

/// Values of a surface. Angles in degrees, strengths in force / length², tension positive.
struct StrengthValues {
  double cohesion = 0;                          ///< Tresca: half the uniaxial strength; not used by von Mises
  double friction_deg = 0;                      ///< Mohr-Coulomb, Drucker-Prager
  double dilation_deg = 0;                      ///< of the flow, for the same two
  double yield_stress = 0;                      ///< von Mises: the uniaxial strength
  std::optional<double> tensile_strength = {};  ///< per principal stress; for cones a limit of the mean stress

  bool operator==(const StrengthValues&) const = default;
};

/// Linear change with the plastic strain κ = ∫ √(2/3) ‖dev dεᵖ‖ to `values`, which then stay. Given is either the
/// strain, or the energy per area of a band in which uniaxial strength falls (Bažant & Oh 1983). With the energy the
/// strain depends on the size of the point.
struct StrengthChange {
  StrengthValues values;
  double plastic_strain = 0;
  double fracture_energy = 0;  ///< force / length; if above 0, it replaces the strain

  bool operator==(const StrengthChange&) const = default;
};

/// Cracks that soften rock until compression has closed them. Under uniaxial stress its modulus is `initial_modulus` up
/// to the closure strain, then Young's modulus.
struct CrackClosure {
  double initial_modulus = 0;  ///< force / length², above 0 and below Young's modulus
  double closure_strain = 0;   ///< above 0: uniaxial compression at which the modulus changes

  bool operator==(const CrackClosure&) const = default;
};

/// Stress intensity at which a crack propagates [force / length^1.5].
struct Toughness {
  double mode_1 = 0;                            ///< K_Ic, above 0
  std::optional<double> mode_2 = {};            ///< K_IIc; empty: that of the criterion of growth
  std::optional<double> tensile_strength = {};  ///< at which a crack starts in intact rock, force / length², above 0;
                                                ///< empty: no crack starts in tension
  std::optional<double> cohesion = {};  ///< at which a closed crack starts in shear, force / length², above 0; needs
                                        ///< `mode_2`; empty: no crack starts in shear
  double friction_deg = 0;              ///< of intact rock in shear, at least 0 and below 90

  bool operator==(const Toughness&) const = default;
};

struct Strength {
  YieldSurface surface = YieldSurface::mohr_coulomb;
  ConeMatching matching = ConeMatching::compression;
  StrengthValues values;
  std::optional<StrengthChange> change = {};

  bool operator==(const Strength&) const = default;
};

}  // namespace keyblock
