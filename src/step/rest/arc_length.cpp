// Solves the equilibrium equations on a cylinder about the last point; see arc_length.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/arc_length.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace keyblock {
namespace {

using namespace tolerances;

/// Solves |a + s b| = length for the s whose a + s b points most along `direction`; empty if the line misses the
/// cylinder.
std::optional<double> on_cylinder(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double length,
                                  const Eigen::VectorXd& direction) {
  const double square = b.squaredNorm(), half = a.dot(b);
  const double root = half * half - square * (a.squaredNorm() - length * length);
  if (!(root >= 0 && square > 0)) return std::nullopt;
  // The two solutions differ by 2 √root / b² times b.
  return (-half + (b.dot(direction) > 0 ? 1 : -1) * std::sqrt(root)) / square;
}

class OnPath {
 public:
  OnPath(LoadedTangent& tangent, const PathPoint& from, PathPoint guess, double length, NewtonRounds& rounds,
         Eigen::VectorXd& last)
      : tangent_(tangent),
        from_(from),
        length_(length),
        rounds_(rounds),
        last_(last),
        load_(tangent.bodies().scene_load()),
        at_(std::move(guess)) {
    look();
  }

  RoundsEnd state() const { return state_of(rounds_.residuals.back()); }

  RoundsEnd find_increment(int) {
    try {
      const LinearFactor& factor = tangent_.factor_at(from_.state, at_.state.d);
      corrected_ = at_.way - Eigen::VectorXd(factor.solve(now_.residual));
      by_share_ = factor.solve(load_);
    } catch (const SingularMatrix&) {
      return RoundsEnd::no_factor;
    }
    change_ = on_cylinder(corrected_, by_share_, length_, at_.way);
    return change_ ? RoundsEnd::open : RoundsEnd::off_path;
  }

  /// Takes the whole increment: a part of it would not lie on the cylinder.
  void take(double) {
    at_.way = corrected_ + *change_ * by_share_;
    at_.share_change += *change_;
    at_.share = from_.share + at_.share_change;
    at_.state.d = from_.state.d + at_.way;
    last_ = at_.state.d;
    look();
  }

  PathPoint end() && {
    at_.state.points = std::move(now_.rock.after);
    return std::move(at_);
  }

 private:
  void look() {
    now_ = tangent_.bodies().balance(from_.state, at_.state.d, at_.share);
    rounds_.residuals.push_back(share_out_of_balance(now_));
  }

  LoadedTangent& tangent_;
  const PathPoint& from_;
  double length_;
  NewtonRounds& rounds_;
  Eigen::VectorXd& last_;
  Eigen::VectorXd load_;
  PathPoint at_;
  LoadedBodies::Balance now_;
  Eigen::VectorXd corrected_, by_share_;
  std::optional<double> change_;
};

}  // namespace

Eigen::VectorXd ArcLength::tangent_at(const PathPoint& from) {
  return tangent_.factor_at(from.state, from.state.d).solve(tangent_.bodies().scene_load());
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
  std::optional<PathPoint> at;
  try {
    at = guess(from, length);
  } catch (const SingularMatrix&) {
    rounds.end = RoundsEnd::no_factor;
    return std::nullopt;
  }
  if (!at) {
    rounds.end = RoundsEnd::off_path;
    return std::nullopt;
  }
  OnPath equations(tangent_, from, std::move(*at), length, rounds, last_);
  WholeIncrements search;
  rounds.end = newton(equations, search, of_newton::kMostRounds);
  if (rounds.end != RoundsEnd::balanced) return std::nullopt;
  PathPoint found = std::move(equations).end();
  if (tangent_.bodies().turned_over(found.state.d) < 0) return found;
  rounds.end = RoundsEnd::turned_over;
  return std::nullopt;
}

}  // namespace keyblock
