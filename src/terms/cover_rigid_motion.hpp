// Computes mass, centre, rotary inertia and momenta of NMM bodies, and the velocities of their rigid motions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "model/continuum.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

/// Rigid motion of one body.
struct RigidMotion {
  double mass = 0;
  Point centre;               ///< centre of mass, present position
  double rotary_inertia = 0;  ///< about the centre
  Point momentum;
  double angular_momentum = 0;  ///< about the centre of mass
  double kinetic_energy = 0;    ///< of all motion, including deformation
};

/// Positions are functions of the covers, x = Σ N_a x_a with x_a = X_a + d_a. For each kind of cover functions, X_a is
/// the node of a cover for its constant function and 0 for the others.
class CoverRigidMotion {
 public:
  /// `mass` as from add_cover_mass; stored as a copy.
  CoverRigidMotion(const Manifold& manifold, const CoverBasis& basis, SparseSystem mass);

  int body_count() const { return static_cast<int>(functions_.size()); }
  /// Returns the functions of each body, ascending; every function belongs to one body.
  const std::vector<std::vector<int>>& functions() const { return functions_; }

  /// Returns x_a of all functions at the start.
  const Eigen::VectorXd& start() const { return start_; }

  /// Returns the motions of all bodies at positions d with velocities v.
  std::vector<RigidMotion> motions(const Eigen::VectorXd& d, const Eigen::VectorXd& v) const;

  /// Returns velocities of the body's functions (rows as `functions`) in columns: 1 in x, 1 in y, 1 rad/time about
  /// `centre`, at positions d.
  Eigen::MatrixX3d modes(int body, const Eigen::VectorXd& d, Point centre) const;

  /// Returns the unknowns after each body was rotated by `angle` about the point, then moved.
  Eigen::VectorXd turned(double angle, Point about, Point moved) const;

 private:
  bool is_constant(int function) const { return function % functions_per_cover_ == 0; }
  double one(int function) const { return is_constant(function) ? 1 : 0; }

  std::vector<std::vector<int>> functions_;
  int functions_per_cover_ = 1;
  Eigen::VectorXd start_;
  SparseSystem mass_;
};

}  // namespace keyblock
