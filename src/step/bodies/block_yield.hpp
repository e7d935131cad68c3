// Models an elastoplastic block, or one with closing cracks, as one point of rock in the block's rotating frame.
// Theory: docs/theory/09-plasticity.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "material/rock_point.hpp"
#include "step/bodies/integrator.hpp"
#include "step/bodies/standard_body.hpp"

namespace keyblock {

/// Stress σ = D (ε0 + B q - εᵖ - w), w the crack strain since the start. The block has its elastic force, and V Bᵀ D
/// (εᵖ + w) against it. εᵖ and w are inelastic strain: intact elastic rock has neither.
struct BlockYield {
  RockPoint rock;
  StrainOperator strain;  ///< B
  Eigen::Matrix3d modulus;

  Eigen::Vector3d strain_at(const Unknowns& q) const { return strain * q; }
  Response respond(const Unknowns& q, const YieldState& before) const { return rock.respond(strain_at(q), before); }
  Eigen::Vector4d inelastic(const Unknowns& q, const YieldState& state) const {
    return rock.inelastic(strain_at(q), state);
  }
  /// Returns V Bᵀ D times an inelastic strain.
  Unknowns inelastic_force(const Eigen::Vector4d& strain) const;
  /// Returns the stored energy less that without inelastic strain.
  double inelastic_energy(const Unknowns& q, const YieldState& state) const;
  /// Returns the part that a step's mean elastic force lacks if cracks close within the step
  /// (RockPoint::missing_stress). missing_stiffness: its derivative by the end.
  Unknowns missing_force(const Unknowns& q0, const YieldState& before, const Unknowns& q1,
                         const YieldState& after) const {
    return rock.area * (strain.transpose() * rock.missing_stress(strain_at(q0), before, strain_at(q1), after));
  }
  UnknownBlock missing_stiffness(const Unknowns& q0, const YieldState& before, const Unknowns& q1,
                                 const YieldState& after) const {
    return of_unknowns(rock.missing_stiffness(strain_at(q0), before, strain_at(q1), after));
  }
  /// Returns V Bᵀ (D - ∂σ/∂ε) B, the stiffness lost to plastic flow and cracks.
  UnknownBlock lost_stiffness(const Response& response) const;

 private:
  /// Returns V Bᵀ C B, symmetrised if the tangent of the law is symmetric.
  UnknownBlock of_unknowns(const Eigen::Matrix3d& stiffness) const;
};

/// Returns the inelastic model of a block; empty for a linear elastic material or a block without strains.
std::optional<BlockYield> block_yield(const Model& model, const Reference& reference, const Settings& settings,
                                      ElementIndex e);

/// Fraction of D times a change of inelastic strain that enters the stress of a step. `strain`: part of the rule's
/// strain. `damping`: part of the mean strain rate; only the strain of intact rock is damped, so that damping does not
/// hold up flow.
struct InelasticShare {
  double strain = 0;
  double damping = 0;

  double total() const { return strain + damping; }
};
InelasticShare inelastic_share(const Body& body, const StepRule& rule, double dt);

}  // namespace keyblock
