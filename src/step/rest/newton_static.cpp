// Rounds of Newton's method with a line search; see newton_static.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/newton_static.hpp"

#include <algorithm>
#include <cmath>

#include "base/progress/headway.hpp"
#include "base/stop.hpp"

namespace keyblock {
namespace {

// Of the largest of the forces: what may be left of them.
constexpr double kBalanced = 1e-9;
// Near a limit load the rock flows in regions that change from round to round: 30 rounds were seen to end well.
constexpr int kMostRounds = 40;
// Of what an increment promises, the fall that is asked for; and how often it is halved, 1/256 being no way forward.
constexpr double kLeastFall = 0.1;
constexpr int kMostHalvings = 8;
// Of the elastic stiffness; ten times as much was seen to double the rounds.
constexpr double kElasticShare = 1e-3;

}  // namespace

std::optional<LoadedState> NewtonStatic::solve(const LoadedState& from, const Eigen::VectorXd& guess, double share,
                                               NewtonRounds& rounds) {
  for (const double elastic_share : {0.0, kElasticShare}) {
    std::optional<LoadedState> found = attempt(from, guess, share, elastic_share, rounds);
    if (found && bodies_->turned_over(found->d) < 0) return found;
  }
  return std::nullopt;
}

std::optional<LoadedState> NewtonStatic::attempt(const LoadedState& from, const Eigen::VectorXd& guess, double share,
                                                 double elastic_share, NewtonRounds& rounds) {
  Eigen::VectorXd d = from.d;
  LoadedBodies::Balance now = bodies_->balance(from, d, share);
  LoadedBodies::Balance guessed = bodies_->balance(from, guess, share);
  if (guessed.residual.norm() < now.residual.norm()) {
    d = guess;
    now = std::move(guessed);
  }
  const auto left = [](const LoadedBodies::Balance& balance) {
    return balance.scale > 0 ? balance.residual.norm() / balance.scale : 0;
  };
  rounds.residuals.push_back(left(now));
  const int most = rounds.count() + kMostRounds;
  while (rounds.residuals.back() > kBalanced) {
    leave_if_stopped();
    if (rounds.count() >= most || !std::isfinite(rounds.residuals.back())) return std::nullopt;
    bodies_->put_tangent(from, d, elastic_share, tangent_);
    Eigen::VectorXd increment;
    try {
      if (!factor_) factor_.emplace(tangent_.matrix());
      factor_->factorise(tangent_.matrix());
      increment = -factor_->solve(now.residual);
    } catch (const SingularMatrix&) {
      return std::nullopt;
    }
    const double before = now.residual.norm();
    double part = 1;
    LoadedBodies::Balance next = bodies_->balance(from, d + increment, share);
    for (int i = 0; i < kMostHalvings && !(next.residual.norm() <= (1 - kLeastFall * part) * before); ++i) {
      if (left(next) <= kBalanced) break;
      part /= 2;
      next = bodies_->balance(from, d + part * increment, share);
    }
    d += part * increment;
    last_ = d;
    now = std::move(next);
    rounds.residuals.push_back(left(now));
    tell_headway("rounds of Newton's method",
                 std::max(share_of_fall(1, left(now), kBalanced), 1 - double(most - rounds.count()) / kMostRounds));
  }
  return LoadedState{std::move(d), std::move(now.rock.after)};
}

}  // namespace keyblock
