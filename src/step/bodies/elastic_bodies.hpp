// Holds the data of NMM bodies that do not change with their motion, integrated once per run. Theory:
// docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuum.hpp"
#include "system/sparse_system.hpp"
#include "terms/cover_elasticity.hpp"
#include "terms/cover_rigid_motion.hpp"
#include "terms/yield/cover_yield.hpp"

namespace keyblock {

/// Damping coefficients: a of a force a M v, b of a stress b D Ė. Ė is the rate of the Green strain; at the start the
/// latter force is b K v. This is objective: a fixed b K would damp a rotating body too.
struct CoverDamping {
  std::vector<double> mass;       ///< a per body, 1 / time; empty: no mass damping
  std::vector<double> stiffness;  ///< b per body, time; empty: no stiffness damping
  bool operator==(const CoverDamping&) const = default;
};

struct ElasticBodies {
  Continuum continuum;
  CoverElasticity elasticity;
  CoverYield yield;  ///< empty without elastoplastic rock
  /// G, a force as in `ghost_force`. It vanishes for every affine d, so that rigid motion stays free. All matrices here
  /// share its groups.
  SparseSystem ghost;
  SparseSystem mass;  ///< M
  bool has_mass_damping = false;
  SparseSystem mass_damping;              ///< a M, with a per body; of no functions if every a is 0
  std::vector<double> stiffness_damping;  ///< b per element; empty if all are 0
  /// H: Nitsche's terms of prescribed displacements, and point springs, a force H d in every motion. Nitsche's terms
  /// use the stress and normal of the initial boundary, so that a fixed part may rotate only as much as it strains. The
  /// load holds body force, tractions, point forces and terms of nonzero prescribed displacements, all in initial
  /// directions and sizes.
  SparseSystem supports;
  CoverRigidMotion rigid;

  explicit ElasticBodies(Continuum with_loads, const CoverDamping& damping = {});

  const CoverBasis& basis() const { return elasticity.basis(); }
  int unknown_count() const { return 2 * basis().function_count(); }
  /// Returns the resisting force of a step from d0, with the memories `before`, to d1 at the weight θ. It sums the
  /// force of the rock, with θ + `more`[e] in element e, ghost_force, and H (d0 + θ (d1 - d0)).
  Eigen::VectorXd force(const CoverYield::Way& way) const;
  /// Returns the static resisting force, the gradient of the energy as long as rock does not flow.
  Eigen::VectorXd force(const Eigen::VectorXd& d, const YieldStates& points) const;
  /// Returns the elastic energy, plus ½ dᵀ G d and ½ dᵀ H d.
  double energy(const Eigen::VectorXd& d, const YieldStates& points) const;
};

}  // namespace keyblock
