// Rounds on a cylinder about the last point; see arc_length.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/arc_length.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "base/stop.hpp"

namespace keyblock {
namespace {

// As in NewtonStatic, of the largest of the forces.
constexpr double kBalanced = 1e-9;
constexpr int kMostRounds = 40;

double left(const LoadedBodies::Balance& balance) {
  return balance.scale > 0 ? balance.residual.norm() / balance.scale : 0;
}

/// Of |a + s b| = length the s whose a + s b points most along `direction`; none where the line misses the cylinder.
std::optional<double> on_cylinder(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double length,
                                  const Eigen::VectorXd& direction) {
  const double square = b.squaredNorm(), half = a.dot(b);
  const double root = half * half - square * (a.squaredNorm() - length * length);
  if (!(root >= 0 && square > 0)) return std::nullopt;
  // The two differ by 2 √root / b² of b.
  return (-half + (b.dot(direction) > 0 ? 1 : -1) * std::sqrt(root)) / square;
}

}  // namespace

const SparseLu& ArcLength::factor_at(const LoadedState& from, const Eigen::VectorXd& d) {
  bodies_->put_tangent(from, d, 0, tangent_);
  if (!factor_) factor_.emplace(tangent_.matrix());
  factor_->factorise(tangent_.matrix());
  return *factor_;
}

Eigen::VectorXd ArcLength::tangent_at(const PathPoint& from) {
  return factor_at(from.state, from.state.d).solve(bodies_->scene_load());
}

double ArcLength::length_of_loads(const PathPoint& from) {
  try {
    return tangent_at(from).norm();
  } catch (const SingularMatrix&) {
    return std::numeric_limits<double>::infinity();
  }
}

std::optional<PathPoint> ArcLength::guess(const PathPoint& from, double length) {
  PathPoint at = from;
  const bool has_way = from.way.norm() > 0;
  if (!has_way) {
    at.way = tangent_at(from);
    at.share_change = 1;
  }
  const double part = length / at.way.norm();
  if (!std::isfinite(part)) return std::nullopt;
  at.way *= part;
  at.share_change *= part;
  at.state.d += at.way;
  at.share += at.share_change;
  return at;
}

std::optional<PathPoint> ArcLength::next(const PathPoint& from, double length, NewtonRounds& rounds) {
  try {
    std::optional<PathPoint> at = guess(from, length);
    if (!at) return std::nullopt;
    const Eigen::VectorXd load = bodies_->scene_load();
    LoadedBodies::Balance now = bodies_->balance(from.state, at->state.d, at->share);
    rounds.residuals.push_back(left(now));
    const int most = rounds.count() + kMostRounds;
    while (rounds.residuals.back() > kBalanced) {
      leave_if_stopped();
      if (rounds.count() >= most || !std::isfinite(rounds.residuals.back())) return std::nullopt;
      const SparseLu& factor = factor_at(from.state, at->state.d);
      const Eigen::VectorXd corrected = at->way - Eigen::VectorXd(factor.solve(now.residual));
      const Eigen::VectorXd by_share = factor.solve(load);
      const std::optional<double> change = on_cylinder(corrected, by_share, length, at->way);
      if (!change) return std::nullopt;
      at->way = corrected + *change * by_share;
      at->share_change += *change;
      at->share = from.share + at->share_change;
      at->state.d = from.state.d + at->way;
      last_ = at->state.d;
      now = bodies_->balance(from.state, at->state.d, at->share);
      rounds.residuals.push_back(left(now));
    }
    if (bodies_->turned_over(at->state.d) >= 0) return std::nullopt;
    at->state.points = std::move(now.rock.after);
    return at;
  } catch (const SingularMatrix&) {
    return std::nullopt;
  }
}

}  // namespace keyblock
