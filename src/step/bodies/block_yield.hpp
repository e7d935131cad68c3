// A block that may yield: one point of rock in the block's own turning frame.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "material/rock_point.hpp"
#include "step/bodies/integrator.hpp"
#include "step/bodies/standard_body.hpp"

namespace keyblock {

/// σ = D (ε0 + B q - εᵖ): the elastic force of the block, and V Bᵀ D εᵖ against it.
struct BlockYield {
  RockPoint rock;
  StrainOperator strain;  ///< B
  Eigen::Matrix3d modulus;

  Eigen::Vector3d strain_at(const Unknowns& q) const { return strain * q; }
  Response respond(const Unknowns& q, const YieldState& before) const { return rock.respond(strain_at(q), before); }
  /// V Bᵀ D εᵖ.
  Unknowns plastic_force(const Eigen::Vector4d& plastic) const;
  /// Of ∫ ½ εᵉ · D εᵉ what there is beside that of no plastic strain.
  double plastic_energy(const Unknowns& q, const YieldState& state) const;
  /// V Bᵀ (D - ∂σ/∂ε) B, made symmetric: what flow takes of the stiffness.
  UnknownBlock lost_stiffness(const Response& response) const;
};

/// None of a material without a strength, or of a block without strains.
std::optional<BlockYield> block_yield(const Model& model, const Reference& reference, const Settings& settings,
                                      ElementIndex e);

/// The share of D Δεᵖ in the stress of a step: what the rule sees of a change of strain, and of its mean rate by
/// damping, which follows elastic strain alone: a block that flows is not held up by it.
struct PlasticShare {
  double strain = 0;
  double damping = 0;

  double total() const { return strain + damping; }
};
PlasticShare plastic_share(const Body& body, const StepRule& rule, double dt);

}  // namespace keyblock
