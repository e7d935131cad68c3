// Stress intensity factors and J of a crack tip from the displacement of a body on covers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "fracture/crack_domain.hpp"
#include "fracture/near_tip_field.hpp"
#include "model/continuum.hpp"

namespace keyblock {

/// A force that acts on a face of a crack, of its own body.
struct FaceForce {
  int element = 0;  ///< whose face it is
  Point at;         ///< undeformed
  Point force;      ///< per unit thickness
  int other = -1;   ///< element that presses there, of a contact between bodies on covers; -1: none
};

/// Bodies and the unknowns of their functions. Views all of them.
struct CoverSolution {
  const Continuum& continuum;
  const CoverBasis& basis;
  const Eigen::VectorXd& d;
  bool is_large = false;  ///< x = X + u under large rotation; else u is that of linear elasticity
  const Eigen::VectorXd* acceleration = nullptr;  ///< of the functions, in time; none at rest
  std::vector<FaceForce> face_forces = {};        ///< beside the tractions of the continuum: of contact
};

struct TipFactors {
  StressIntensity k;       ///< F/L^1.5
  double j = 0;            ///< energy release rate by the domain form of J, F/L; (K_I² + K_II²)/E' but for the error
  bool is_closed = false;  ///< contact presses the faces together at the tip: K_I is 0
};

/// Interaction integral with the near-tip field of each mode (Yau, Wang & Corten 1980; domain form of Moran & Shih
/// 1987), and the domain form of J (Rice 1968; Li, Shih & Needleman 1985):
///     I = ∫ (σ_ij uᵃ_i,1 + σᵃ_ij u_i,1 - σᵃ:ε δ_1j) q_,j dA - ∫ t·uᵃ_,1 q ds - ∫ (b - ρ ü)·uᵃ_,1 q dA,
///     K = E' I / 2.
/// σ is the change of stress since the start, so that b has the divergence of the initial stress in it, and t, on the
/// faces of the crack, less what that stress has there. The turning of the rock at the tip is taken out of u.
///
/// Where contact presses the faces together within two sides of the tip they do not open, and K_I is 0; nor do they
/// where it does so within six sides and the integral gives a K_I below 0, by which they would overlap. What the
/// integral says of it is the error of the faces' term: elements near the tip answer forces on its faces otherwise than
/// the rock does, by the root of their sides. It is taken for that up to three times the pressure times this root. On a
/// face at θ = ±π the near-tip gradients of both modes are one function of r, ∂uᵃ_2/∂x_1 of mode I and ∂uᵃ_1/∂x_1 of
/// mode II (Williams 1957), so that the error of K_II is that of K_I times F_1/F_2 of the contact forces near the tip,
/// and is taken out: 5 % of K_II at friction 0.6 where sides are c/320. The traction of an initial stress is smooth and
/// makes none of it (case closed_crack_in_situ). J stays that of the domain.
TipFactors factors_at(const CoverSolution& solution, const CrackTip& tip, const CrackDomain& domain);

/// Elastic constants of the rock at a tip.
PlaneElasticity rock_at(const Continuum& continuum, const CrackTip& tip);

/// The element that holds the tip, or has it on its edge; -1: none.
int element_of(const Manifold& manifold, const CrackTip& tip);

}  // namespace keyblock
