// Solves the equilibrium equations at a load fraction; see share_control.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/share_control.hpp"

#include <algorithm>
#include <utility>

#include "base/context.hpp"

namespace keyblock {
namespace {

using namespace tolerances;

class AtShare {
 public:
  AtShare(LoadedTangent& tangent, const LoadedState& from, double share, double elastic_share, NewtonRounds& rounds,
          Eigen::VectorXd& last)
      : tangent_(tangent),
        from_(from),
        share_(share),
        elastic_share_(elastic_share),
        rounds_(rounds),
        last_(last),
        d_(from.d),
        now_(balance(d_)) {}

  void begin_at_better(const Eigen::VectorXd& guess) {
    LoadedBodies::Balance guessed = balance(guess);
    if (guessed.residual.norm() < now_.residual.norm()) {
      d_ = guess;
      now_ = std::move(guessed);
    }
    rounds_.residuals.push_back(share_out_of_balance(now_));
    tell_headway("Newton iterations", std::max(share_of_fall(1, rounds_.residuals.back(), of_newton::kBalanced),
                                               static_cast<double>(rounds_.count()) / of_newton::kMostRounds));
  }

  RoundsEnd state() const { return state_of(rounds_.residuals.back()); }

  RoundsEnd find_increment(int) {
    try {
      increment_ = -tangent_.factor_at(from_, d_, elastic_share_).solve(now_.residual);
      return RoundsEnd::open;
    } catch (const SingularMatrix&) {
      return RoundsEnd::no_factor;
    }
  }

  double residual() const { return now_.residual.norm(); }
  double residual_with(double part) {
    next_ = balance(d_ + part * increment_);
    return next_.residual.norm();
  }
  bool would_balance() const { return share_out_of_balance(next_) <= of_newton::kBalanced; }

  /// `part` is the part whose residual was computed last.
  void take(double part) {
    d_ += part * increment_;
    last_ = d_;
    now_ = std::move(next_);
    rounds_.residuals.push_back(share_out_of_balance(now_));
  }

  LoadedState end() && { return {std::move(d_), std::move(now_.rock.after)}; }

 private:
  LoadedBodies::Balance balance(const Eigen::VectorXd& d) const { return tangent_.bodies().balance(from_, d, share_); }

  LoadedTangent& tangent_;
  const LoadedState& from_;
  double share_;
  double elastic_share_;
  NewtonRounds& rounds_;
  Eigen::VectorXd& last_;
  Eigen::VectorXd d_;
  LoadedBodies::Balance now_;
  Eigen::VectorXd increment_;
  LoadedBodies::Balance next_;
};

}  // namespace

std::optional<LoadedState> ShareControl::solve(const LoadedState& from, const Eigen::VectorXd& guess, double share,
                                               NewtonRounds& rounds) {
  for (const double elastic_share : {0.0, of_newton::kElasticShare}) {
    AtShare equations(tangent_, from, share, elastic_share, rounds, last_);
    equations.begin_at_better(guess);
    Backtracking search;
    rounds.end = newton(equations, search, of_newton::kMostRounds);
    if (rounds.end != RoundsEnd::balanced) continue;
    LoadedState found = std::move(equations).end();
    if (tangent_.bodies().turned_over(found.d) < 0) return found;
    rounds.end = RoundsEnd::turned_over;
  }
  return std::nullopt;
}

}  // namespace keyblock
