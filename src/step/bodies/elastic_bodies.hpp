// Bodies on covers as a run of steps needs them: all that does not change with the motion, integrated once.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuum.hpp"
#include "system/sparse_system.hpp"
#include "terms/cover_elasticity.hpp"
#include "terms/cover_rigid_motion.hpp"
#include "terms/yield/cover_yield.hpp"

namespace keyblock {

/// a of a damping force a M v; b of a stress b D Ė against the rate of the Green strain, b K v at the start. It is
/// objective: a turning body is not damped, as it would be by a fixed b K.
struct CoverDamping {
  std::vector<double> mass;       ///< a of each body, 1 / time; empty: none is damped so
  std::vector<double> stiffness;  ///< b of each body, time; empty: none
  bool operator==(const CoverDamping&) const = default;
};

struct ElasticBodies {
  Continuum continuum;
  CoverElasticity elasticity;
  CoverYield yield;  ///< empty where nothing may yield
  /// G, a force after `ghost_force`: it vanishes for every affine d, so that rigid motion stays free. Its groups are
  /// those of every matrix here.
  SparseSystem ghost;
  SparseSystem mass;  ///< M
  bool has_mass_damping = false;
  SparseSystem mass_damping;              ///< a M, with a of each body; of no functions where every a is 0
  std::vector<double> stiffness_damping;  ///< b of each element; empty where all are 0
  /// H: Nitsche's terms of prescribed displacements and point springs, a force H d whatever the motion. Nitsche's terms
  /// take stress and normal of the boundary as at the start: a held part may not turn by more than a strain. Its load:
  /// body force, tractions, point forces and what prescribed displacements other than 0 need, all in directions and
  /// sizes of the start.
  SparseSystem supports;
  CoverRigidMotion rigid;

  explicit ElasticBodies(Continuum with_loads, const CoverDamping& damping = {});

  const CoverBasis& basis() const { return elasticity.basis(); }
  int unknown_count() const { return 2 * basis().function_count(); }
  /// What resists the way from d0, where yielding rock has the memories `before`, to d1 at the weight θ: the force of
  /// the rock, with θ + `more`[e] in element e, ghost_force, and H (d0 + θ (d1 - d0)).
  Eigen::VectorXd force(const CoverYield::Way& way) const;
  /// At rest: the gradient of the energy, as long as rock does not flow.
  Eigen::VectorXd force(const Eigen::VectorXd& d, const YieldStates& points) const;
  /// Of elasticity, ½ dᵀ G d and ½ dᵀ H d.
  double energy(const Eigen::VectorXd& d, const YieldStates& points) const;
};

}  // namespace keyblock
