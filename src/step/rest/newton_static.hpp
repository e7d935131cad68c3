// Newton's method for bodies on covers at rest: the displacement at which loads, supports and rock that may yield
// balance.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "step/bodies/loaded_bodies.hpp"
#include "system/sparse_lu.hpp"

namespace keyblock {

/// How a search went.
struct NewtonRounds {
  std::vector<double> residuals;  ///< before each round and at the end, over the largest of the forces

  int count() const { return static_cast<int>(residuals.size()) - 1; }
};

/// The exact tangent in each round, by LU, for it need not be symmetric; an increment is halved while the residual does
/// not fall by a tenth of what it promises (Armijo 1966). Where that fails, once more with a thousandth of the elastic
/// stiffness in the tangent: in a corner of the surface the exact one has no inverse. A state with an element turned
/// over is none. One object serves all steps of a scene: the order of elimination is found once.
class NewtonStatic {
 public:
  explicit NewtonStatic(const LoadedBodies& bodies) : bodies_(&bodies), tangent_(bodies.tangent()) {}

  /// The state at this share of the loads, reached from `from`; none where rounds do not bring it there. They begin at
  /// `guess` if less is out of balance there than at `from`. `rounds` is filled either way.
  std::optional<LoadedState> solve(const LoadedState& from, const Eigen::VectorXd& guess, double share,
                                   NewtonRounds& rounds);

  /// The unknowns where the last search ended, found or not; empty before the first.
  const Eigen::VectorXd& last() const { return last_; }

 private:
  std::optional<LoadedState> attempt(const LoadedState& from, const Eigen::VectorXd& guess, double share,
                                     double elastic_share, NewtonRounds& rounds);

  const LoadedBodies* bodies_;
  WholeSystem tangent_;
  std::optional<SparseLu> factor_;
  Eigen::VectorXd last_;
};

}  // namespace keyblock
