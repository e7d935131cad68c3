// Computes the force balance of NMM bodies without contact at a load fraction, and its tangent. Theory:
// docs/theory/07-initial-state-and-statics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "base/archive.hpp"
#include "result/force_balance.hpp"
#include "system/sparse_system.hpp"
#include "system/whole_system.hpp"
#include "terms/cover_elasticity.hpp"
#include "terms/ghost_penalty.hpp"
#include "terms/held_edges.hpp"
#include "terms/yield/cover_yield.hpp"

namespace keyblock {

/// Unknowns, and memories of the points of elastoplastic rock.
struct LoadedState {
  Eigen::VectorXd d;
  YieldStates points;
};

/// Forces out of balance at the start of a scene, R0, are released in proportion. At the load fraction s of the scene
///   r(d, s) = f(d) + K d - p(s) - F - (1 - s) R0,
/// f of the rock, K and p of springs, fixed edges and the ghost penalty of elastic rock, F of the loads. New loads of a
/// scene grow with s, and the support of excavated rock vanishes with s. Rock in equilibrium under its initial stress
/// does not move.
class LoadedBodies {
 public:
  explicit LoadedBodies(const Continuum& continuum);

  const Continuum& continuum() const { return continuum_; }
  const CoverBasis& basis() const { return basis_; }
  const CoverYield& yield() const { return yield_; }
  const CoverElasticity& elasticity() const { return elasticity_; }

  /// Returns the undisplaced state, with the memories of the initial stress.
  LoadedState at_start() const;

  /// Begins a scene. `before`: bodies of the last scene; null for the first.
  void begin(const LoadedState& start, const LoadedBodies* before);

  struct Balance {
    Eigen::VectorXd residual;
    double scale = 0;  ///< norm of the largest force in the residual, or of those at the start of the scene
    CoverYield::Answer rock;
  };
  /// Returns the balance at d, for points with the memories of `from`.
  Balance balance(const LoadedState& from, const Eigen::VectorXd& d, double share) const;

  /// Returns -∂r/∂s, the same at every d: the new loads of the scene, and the pull of edges that it moves.
  Eigen::VectorXd scene_load() const;

  /// Returns a matrix for tangents; put_tangent writes ∂r/∂d into it.
  WholeSystem tangent() const;
  void put_tangent(const LoadedState& from, const Eigen::VectorXd& d, double elastic_share, WholeSystem& tangent) const;

  /// Returns an element whose area is zero or negative; -1: no such element.
  int turned_over(const Eigen::VectorXd& d) const;

  /// Returns the sums of loads at their load fraction, supports and springs.
  ForceBalance forces(const Eigen::VectorXd& d, double share) const;

  std::vector<double> driven(double share) const { return held_.driven(share); }

  /// Saves or restores the data that a later scene needs besides its model.
  void describe(Archive& archive);

 private:
  Continuum continuum_;
  CoverBasis basis_;
  CoverElasticity elasticity_;
  CoverYield yield_;
  HeldEdges held_;
  std::vector<GhostPair> ghost_pairs_;  // of elements that stay elastic
  FunctionGroups groups_;
  SparseSystem loads_;          // F alone
  SparseSystem stiffness_;      // K
  Eigen::VectorXd unbalanced_;  // R0
  double scale_at_start_ = 0;
};

}  // namespace keyblock
