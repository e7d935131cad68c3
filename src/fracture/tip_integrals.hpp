// Computes stress intensity factors and J of a crack tip from the displacement of an NMM body.
// Theory: docs/theory/10-fracture.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "fracture/crack_domain.hpp"
#include "fracture/near_tip_field.hpp"
#include "model/continuum.hpp"

namespace keyblock {

/// Force on a face of a crack, acting on the body of the face.
struct FaceForce {
  int element = 0;  ///< element of the face
  Point at;         ///< undeformed
  Point force;      ///< per unit thickness
  int other = -1;   ///< element that presses there, for contact between NMM bodies; -1: none
};

/// Bodies and the unknowns of their functions. Keeps references to all of them.
struct CoverSolution {
  const Continuum& continuum;
  const CoverBasis& basis;
  const Eigen::VectorXd& d;
  bool is_large = false;  ///< x = X + u under large rotation; else u is that of linear elasticity
  const Eigen::VectorXd* acceleration = nullptr;  ///< second time derivative of the unknowns; null in statics
  std::vector<FaceForce> face_forces = {};        ///< contact forces, added to the tractions of the continuum
};

struct TipFactors {
  StressIntensity k;       ///< F/L^1.5
  double j = 0;            ///< energy release rate by the domain form of J, F/L; (K_I² + K_II²)/E' up to the error
  bool is_closed = false;  ///< contact presses the faces together at the tip: K_I is 0
};

/// Returns factors by the interaction integral with the near-tip field of each mode (Yau, Wang & Corten 1980; domain
/// form of Moran & Shih 1987). J is found by its domain form (Rice 1968; Li, Shih & Needleman 1985):
///       I = ∫ (σ_ij uᵃ_i,1 + σᵃ_ij u_i,1 - σᵃ:ε δ_1j) q_,j dA - ∫ t·uᵃ_,1 q ds - ∫ (b - ρ ü)·uᵃ_,1 q dA,
///       K = E' I / 2.
/// σ is the change of stress since the start. b therefore includes the divergence of the initial stress; t, on the
/// faces of the crack, excludes the traction of that stress. The rotation of the rock at the tip is removed from u.
///
/// If contact presses the faces together within two sides of the tip they do not open, and K_I is 0. K_I is also 0 if
/// contact does so within six sides and the integral gives a negative K_I, by which they would overlap. The remainder
/// of the integral is then the error of the faces' term. Elements near the tip respond to forces on its faces otherwise
/// than the rock does, by the root of their sides. The remainder counts as this error up to three times the pressure
/// times this root.
///
/// On a face at θ = ±π the near-tip gradients of both modes are the same function of r (Williams 1957). They are
/// ∂uᵃ_2/∂x_1 of mode I and ∂uᵃ_1/∂x_1 of mode II. The error of K_II is therefore that of K_I times F_1/F_2 of the
/// contact forces near the tip. It is removed: 5 % of K_II at friction 0.6 with sides of c/320. The traction of an
/// initial stress is smooth and causes no such error (case closed_crack_in_situ). J stays that of the domain.
TipFactors factors_at(const CoverSolution& solution, const CrackTip& tip, const CrackDomain& domain);

/// Returns the elastic constants of the rock at a tip.
PlaneElasticity rock_at(const Continuum& continuum, const CrackTip& tip);

/// Returns the element that holds the tip, inside or on its edge; -1: none.
int element_of(const Manifold& manifold, const CrackTip& tip);

}  // namespace keyblock
