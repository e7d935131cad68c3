// Bodies on covers that nothing touches under a share of a scene's loads: what is out of balance, and its tangent.
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

/// Unknowns, and what the points of yielding rock remember.
struct LoadedState {
  Eigen::VectorXd d;
  YieldStates points;
};

/// The forces of a scene that were out of balance when it began, R0, are released in proportion: at the share s of the
/// scene
///     r(d, s) = f(d) + K d - p(s) - F - (1 - s) R0,
/// f of the rock, K and p of springs, held edges and the ghost penalty of elastic rock, F of the loads. Loads that are
/// new in a scene grow with s, what is dug out gives way with s, and rock in balance under its initial stress stays
/// where it is.
class LoadedBodies {
 public:
  explicit LoadedBodies(const Continuum& continuum);

  const Continuum& continuum() const { return continuum_; }
  const CoverBasis& basis() const { return basis_; }
  const CoverYield& yield() const { return yield_; }
  const CoverElasticity& elasticity() const { return elasticity_; }

  /// Undisplaced, with the memories of the initial stress.
  LoadedState at_start() const;

  /// Begins a scene: `before` is that of the scene before, none of the first.
  void begin(const LoadedState& start, const LoadedBodies* before);

  struct Balance {
    Eigen::VectorXd residual;
    double scale = 0;  ///< norm of the largest of the forces that make it up, or that were there when the scene began
    CoverYield::Answer rock;
  };
  /// At d, where the points have the memories of `from`.
  Balance balance(const LoadedState& from, const Eigen::VectorXd& d, double share) const;

  /// -∂r/∂s, the same at every d: the loads that the scene brings, and what edges that it moves are pulled by.
  Eigen::VectorXd scene_load() const;

  /// A matrix for tangents, and ∂r/∂d put into it.
  WholeSystem tangent() const;
  void put_tangent(const LoadedState& from, const Eigen::VectorXd& d, double elastic_share, WholeSystem& tangent) const;

  /// An element whose area is none or less; -1: there is none.
  int turned_over(const Eigen::VectorXd& d) const;

  /// Loads as far as they are on, supports, springs.
  ForceBalance forces(const Eigen::VectorXd& d, double share) const;

  std::vector<double> driven(double share) const { return held_.driven(share); }

  /// What a scene that goes on depends on beside its model.
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
