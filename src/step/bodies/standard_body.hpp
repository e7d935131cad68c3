// Holds the constant matrices of an element in its own coordinates. Theory: docs/theory/02-equations-of-motion.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/kinematics.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Number of unknowns without strain, which come first in the bases of movable blocks.
inline constexpr int kRigidUnknowns = 3;
inline constexpr int kMostStrains = kMostUnknowns - kRigidUnknowns;

/// Matrices of one block. Mass and stiffness do not change with the motion: rotation is an unknown of its own and
/// strain is measured in the block frame. Terms of order ω² ε are left out.
struct Body {
  using Stiffness = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMostStrains, kMostStrains>;

  UnknownBlock mass;
  Stiffness stiffness;           ///< of the strains, the last unknowns; the others have no stiffness
  double mass_damping = 0;       ///< a of the damping a M + b K, 1 / time
  double stiffness_damping = 0;  ///< b, time
  Unknowns initial_stress;       ///< force of the initial stress on the unknowns
  Unknowns weight;
  double size = 0;  ///< largest distance of a vertex from the centroid
  double area = 0;
  double slowest_frequency = 0;  ///< ω₁ of the strain modes of the free block, 1 / time; 0 without strains

  Eigen::Index strain_count() const { return stiffness.rows(); }
  /// Returns K q.
  Unknowns elastic_force(const Unknowns& q) const {
    Unknowns force = Unknowns::Zero(q.size());
    force.tail(strain_count()) = stiffness * q.tail(strain_count());
    return force;
  }
  /// Returns x M + y K.
  UnknownBlock sum_of(double x, double y) const {
    UnknownBlock sum = x * mass;
    sum.bottomRightCorner(strain_count(), strain_count()) += y * stiffness;
    return sum;
  }
  /// Returns (a M + b K) v.
  Unknowns damping_force(const Unknowns& v) const {
    return mass_damping * (mass * v) + stiffness_damping * elastic_force(v);
  }
};

using Bodies = Table<ElementIndex, Body>;

Bodies bodies_of(const Model& model, const Reference& reference, const Settings& settings);

/// Returns M⁻¹ of each body.
Table<ElementIndex, UnknownBlock> mass_inverses(const Bodies& bodies);

/// Returns the inverse masses of translation and rotation alone; zero in strain rows and columns.
Table<ElementIndex, UnknownBlock> rigid_mass_inverses(const Bodies& bodies);

/// Returns the stress in the block frame under the strain of q.
Stress block_stress(const Model& model, ElementIndex element, const Reference& reference, const Settings& settings,
                    const Unknowns& q);

/// Returns σ rotated by `angle`: R σ Rᵀ.
Stress turned(const Stress& stress, double angle);

}  // namespace keyblock
