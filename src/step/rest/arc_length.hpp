// Follows the path of equilibria of NMM bodies beyond limit loads, in steps of given length; loads may fall along it.
// Theory: docs/theory/07-initial-state-and-statics.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "step/rest/loaded_tangent.hpp"

namespace keyblock {

/// Point on a path, with the step that led to it.
struct PathPoint {
  LoadedState state;
  double share = 0;         ///< load fraction of the scene
  Eigen::VectorXd way;      ///< Δd of the last step; zero at the start of the path
  double share_change = 0;  ///< change of `share` in that step
};

/// Newton's method under arc-length control (Riks 1979), on a cylinder: |Δd| = l, with the load fraction as unknown
/// (Crisfield 1981). Each iteration solves K δ1 = -r and K δ2 = p, p the loads of the whole scene. Two load fractions
/// put Δd + δ1 + δs δ2 on the cylinder; the one that continues in the direction of the step is taken. The last step
/// predicts the next and gives its direction: falling loads keep falling. Elasticity predicts the first step.
/// Iterations stop as those of ShareControl do.
class ArcLength {
 public:
  explicit ArcLength(const LoadedBodies& bodies) : tangent_(bodies) {}

  /// Returns |Δd| per load fraction at a point, for the response of rock to an infinitesimal strain. The result is 0
  /// without loads and infinite if the tangent has no inverse.
  double length_of_loads(const PathPoint& from);

  /// Returns the next point at this distance; empty if the iterations find none. Always fills `rounds`.
  std::optional<PathPoint> next(const PathPoint& from, double length, NewtonRounds& rounds);

  /// Returns the unknowns at the end of the last search; empty before the first.
  const Eigen::VectorXd& last() const { return last_; }

 private:
  Eigen::VectorXd tangent_at(const PathPoint& from);
  std::optional<PathPoint> guess(const PathPoint& from, double length);

  LoadedTangent tangent_;
  Eigen::VectorXd last_;
};

}  // namespace keyblock
