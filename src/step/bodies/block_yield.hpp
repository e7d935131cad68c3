// A block that may yield or has cracks that close: one point of rock in the block's own turning frame.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "material/rock_point.hpp"
#include "step/bodies/integrator.hpp"
#include "step/bodies/standard_body.hpp"

namespace keyblock {

/// σ = D (ε0 + B q - εᵖ - w): the elastic force of the block, and V Bᵀ D (εᵖ + w) against it, w the crack strain since
/// the start. Both are inelastic strain: what intact elastic rock would not have.
struct BlockYield {
  RockPoint rock;
  StrainOperator strain;  ///< B
  Eigen::Matrix3d modulus;

  Eigen::Vector3d strain_at(const Unknowns& q) const { return strain * q; }
  Response respond(const Unknowns& q, const YieldState& before) const { return rock.respond(strain_at(q), before); }
  Eigen::Vector4d inelastic(const Unknowns& q, const YieldState& state) const {
    return rock.inelastic(strain_at(q), state);
  }
  /// V Bᵀ D times an inelastic strain.
  Unknowns inelastic_force(const Eigen::Vector4d& strain) const;
  /// Of the energy stored what there is beside that of no inelastic strain.
  double inelastic_energy(const Unknowns& q, const YieldState& state) const;
  /// What the mean elastic force of a step lacks where cracks close on the way (RockPoint::missing_stress), and its
  /// derivative by the end.
  Unknowns missing_force(const Unknowns& q0, const YieldState& before, const Unknowns& q1,
                         const YieldState& after) const {
    return rock.area * (strain.transpose() * rock.missing_stress(strain_at(q0), before, strain_at(q1), after));
  }
  UnknownBlock missing_stiffness(const Unknowns& q0, const YieldState& before, const Unknowns& q1,
                                 const YieldState& after) const {
    return of_unknowns(rock.missing_stiffness(strain_at(q0), before, strain_at(q1), after));
  }
  /// V Bᵀ (D - ∂σ/∂ε) B: what flow and cracks take of the stiffness.
  UnknownBlock lost_stiffness(const Response& response) const;

 private:
  /// V Bᵀ C B, made symmetric where the law's tangent is.
  UnknownBlock of_unknowns(const Eigen::Matrix3d& stiffness) const;
};

/// None of a linear elastic material, or of a block without strains.
std::optional<BlockYield> block_yield(const Model& model, const Reference& reference, const Settings& settings,
                                      ElementIndex e);

/// The share of D times a change of inelastic strain in the stress of a step: what the rule sees of a change of strain,
/// and of its mean rate by damping, which follows the strain of intact rock alone: a block that flows is not held up.
struct InelasticShare {
  double strain = 0;
  double damping = 0;

  double total() const { return strain + damping; }
};
InelasticShare inelastic_share(const Body& body, const StepRule& rule, double dt);

}  // namespace keyblock
