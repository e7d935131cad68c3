// Solves for the static equilibrium of NMM bodies at a load fraction by Newton's method. Loads, supports and
// elastoplastic rock balance there. Theory: docs/theory/07-initial-state-and-statics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/rest/loaded_tangent.hpp"

namespace keyblock {

/// Newton's method under control by the load fraction, which scales loads and the motion of driven edges alike. It uses
/// the exact tangent and Backtracking. The exact tangent has no inverse in a corner of the yield surface. A second
/// attempt therefore adds a thousandth of the elastic stiffness. States with an inverted element are rejected.
class ShareControl {
 public:
  explicit ShareControl(const LoadedBodies& bodies) : tangent_(bodies) {}

  /// Returns the state at this load fraction, reached from `from`; empty if the iterations find none. They begin at
  /// `guess` if its imbalance is smaller than that of `from`. Always fills `rounds`.
  std::optional<LoadedState> solve(const LoadedState& from, const Eigen::VectorXd& guess, double share,
                                   NewtonRounds& rounds);

  /// Returns the unknowns at the end of the last search, successful or not; empty before the first.
  const Eigen::VectorXd& last() const { return last_; }

 private:
  LoadedTangent tangent_;
  Eigen::VectorXd last_;
};

}  // namespace keyblock
