// Newton's method for bodies on covers at rest, by load or by displacement: the state at which loads, supports and rock
// that may yield balance.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/rest/loaded_tangent.hpp"

namespace keyblock {

/// Control by a share of the scene, of its loads as of the ways of the edges that it drives. The exact tangent in each
/// round and Backtracking. Where that fails, once more with a thousandth of the elastic stiffness in the tangent: in a
/// corner of the surface the exact one has no inverse. A state with an element turned over is none.
class ShareControl {
 public:
  explicit ShareControl(const LoadedBodies& bodies) : tangent_(bodies) {}

  /// The state at this share, reached from `from`; none where rounds do not bring it there. They begin at `guess` if
  /// less is out of balance there than at `from`. `rounds` is filled either way.
  std::optional<LoadedState> solve(const LoadedState& from, const Eigen::VectorXd& guess, double share,
                                   NewtonRounds& rounds);

  /// The unknowns where the last search ended, found or not; empty before the first.
  const Eigen::VectorXd& last() const { return last_; }

 private:
  LoadedTangent tangent_;
  Eigen::VectorXd last_;
};

}  // namespace keyblock
