// The path of equilibria of bodies on covers beyond limit loads: steps of a given length, on which the loads may fall.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "step/rest/loaded_tangent.hpp"

namespace keyblock {

/// Where a path has come to, and how it came there.
struct PathPoint {
  LoadedState state;
  double share = 0;         ///< of the scene's loads
  Eigen::VectorXd way;      ///< Δd of the last step; zero at the start of the path
  double share_change = 0;  ///< in it
};

/// Newton's method under control by arc length (Riks 1979), on a cylinder: |Δd| = l, the share of the loads being
/// sought with it (Crisfield 1981). In each round K δ1 = -r and K δ2 = p, p what the loads of the whole scene are; of
/// the two shares that Δd + δ1 + δs δ2 has on the cylinder that is taken which goes on in the direction of the step.
/// The next step is guessed along the last, by which it also knows which way is on: a share that has fallen goes on
/// falling. The first is guessed by elasticity. Rounds stop as those of ShareControl do.
class ArcLength {
 public:
  explicit ArcLength(const LoadedBodies& bodies) : tangent_(bodies) {}

  /// |Δd| of a point per share of the loads, of rock as it answers the least strain; 0 without loads, infinity where
  /// the tangent has no inverse.
  double length_of_loads(const PathPoint& from);

  /// The next point, at this distance; none where rounds do not bring it there. `rounds` is filled either way.
  std::optional<PathPoint> next(const PathPoint& from, double length, NewtonRounds& rounds);

  /// The unknowns where the last search ended; empty before the first.
  const Eigen::VectorXd& last() const { return last_; }

 private:
  Eigen::VectorXd tangent_at(const PathPoint& from);
  std::optional<PathPoint> guess(const PathPoint& from, double length);

  LoadedTangent tangent_;
  Eigen::VectorXd last_;
};

}  // namespace keyblock
