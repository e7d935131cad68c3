// The constant matrices of an element in its own coordinates, and what one step makes of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/kinematics.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Unknowns that do not deform come first, in the bases of a block that may move.
inline constexpr int kRigidUnknowns = 3;
inline constexpr int kMostStrains = kMostUnknowns - kRigidUnknowns;

/// Mass and stiffness do not change with the motion: rotation is an unknown of its own and strain is measured in the
/// block frame (terms of order ω² ε are left out).
struct Body {
  using Stiffness = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMostStrains, kMostStrains>;

  UnknownBlock mass;
  Stiffness stiffness;           ///< of the strains, the last unknowns; the others have none
  double mass_damping = 0;       ///< a of the damping a M + b K, 1 / time
  double stiffness_damping = 0;  ///< b, time
  Unknowns initial_stress;       ///< force that the stress at the start exerts on the unknowns
  Unknowns weight;
  double size = 0;  ///< largest distance of a vertex from the centroid
  double area = 0;
  double slowest_frequency = 0;  ///< ω₁ of the strain modes of the free block, 1 / time; 0 without strains

  Eigen::Index strain_count() const { return stiffness.rows(); }
  /// K q.
  Unknowns elastic_force(const Unknowns& q) const {
    Unknowns force = Unknowns::Zero(q.size());
    force.tail(strain_count()) = stiffness * q.tail(strain_count());
    return force;
  }
  /// x M + y K.
  UnknownBlock sum_of(double x, double y) const {
    UnknownBlock sum = x * mass;
    sum.bottomRightCorner(strain_count(), strain_count()) += y * stiffness;
    return sum;
  }
  /// (a M + b K) v.
  Unknowns damping_force(const Unknowns& v) const {
    return mass_damping * (mass * v) + stiffness_damping * elastic_force(v);
  }
};

using Bodies = Table<ElementIndex, Body>;

Bodies bodies_of(const Model& model, const Reference& reference, const Settings& settings);

/// M⁻¹ of each body.
Table<ElementIndex, UnknownBlock> mass_inverses(const Bodies& bodies);

/// The same of translation and rotation alone; zero in strain rows and columns.
Table<ElementIndex, UnknownBlock> rigid_mass_inverses(const Bodies& bodies);

/// Stress in the block frame under the strain of q.
Stress block_stress(const Model& model, ElementIndex element, const Reference& reference, const Settings& settings,
                    const Unknowns& q);

/// σ turned by `angle`: R σ Rᵀ.
Stress turned(const Stress& stress, double angle);

}  // namespace keyblock
