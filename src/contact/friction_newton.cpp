// Active set after active set, proximal round after proximal round.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/friction_newton.hpp"

#include <Eigen/LU>
#include <array>
#include <set>

namespace keyblock {
namespace {

// Weights of the proximal term over W_ii, tried in turn: small ones need few rounds but cycle on jointed masses.
constexpr std::array<double, 3> kProximal{1e-3, 1e-2, 1e-1};
// Each round shrinks the part of the error that W sees by about the weight: five reach round-off at 1e-3, the rest is reserve.
constexpr int kMostRounds = 30;
// An acceptable residual that a round improves by less than this is left as it is.
constexpr double kProgress = 0.5;
// Active sets of one round; a cycle is found long before.
constexpr int kMostSets = 60;

class Newton {
 public:
  Newton(const FrictionalProblem& problem, const Eigen::VectorXd& start) : problem_(problem) {
    solution_.forces = start;
    solution_.residual = residual(problem, start);
  }

  FrictionalSolution run() {
    for (double weight : kProximal) {
      if (solution_.residual <= problem_.acceptable && !is_first(weight)) break;
      forces_ = solution_.forces;
      for (int round = 0; round < kMostRounds && !is_solved(); ++round) {
        const double before = solution_.residual;
        if (!settle(regularised(weight))) break;
        if (solution_.residual <= problem_.acceptable && solution_.residual > kProgress * before) break;
      }
    }
    return std::move(solution_);
  }

 private:
  FrictionalProblem regularised(double weight) const {
    FrictionalProblem regular = problem_;
    const Eigen::VectorXd added = weight * problem_.w.diagonal();
    regular.w.diagonal() += added;
    regular.b -= added.cwiseProduct(forces_);
    return regular;
  }

  // False if the active sets go round in a cycle.
  bool settle(const FrictionalProblem& regular) {
    std::set<std::vector<Grip>> visited;
    std::vector<Grip> grips = natural_map(regular, forces_).grips;
    for (int i = 0; i < kMostSets; ++i) {
      visited.insert(grips);
      forces_ = forces_for(regular, grips);
      ++solution_.solves;
      keep_best();
      if (is_solved()) return true;
      const std::vector<Grip> next = natural_map(regular, forces_).grips;
      if (next == grips) return true;
      if (visited.contains(next)) {
        name_undecided(grips, next);
        return false;
      }
      grips = next;
    }
    return false;
  }

  // Open: λ = 0. Stick: yn = yt = 0. Slip: yn = 0, λt = ± μ λn, which makes the matrix nonsymmetric.
  static Eigen::VectorXd forces_for(const FrictionalProblem& p, const std::vector<Grip>& grips) {
    Eigen::MatrixXd a = Eigen::MatrixXd::Identity(p.w.rows(), p.w.cols());
    Eigen::VectorXd right = Eigen::VectorXd::Zero(p.w.rows());
    const auto touch = [&](Eigen::Index row) {
      a.row(row) = p.w.row(row) / p.w(row, row);
      right[row] = -p.b[row] / p.w(row, row);
    };
    for (std::size_t i = 0; i < p.count(); ++i) {
      const auto n = static_cast<Eigen::Index>(2 * i);
      if (grips[i] == Grip::open) continue;
      touch(n);
      if (grips[i] == Grip::stick) touch(n + 1);
      if (grips[i] == Grip::slip_forward) a(n + 1, n) = -p.friction[i];
      if (grips[i] == Grip::slip_backward) a(n + 1, n) = p.friction[i];
    }
    return a.partialPivLu().solve(right);
  }

  static bool is_first(double weight) { return weight == kProximal.front(); }
  bool is_solved() const { return solution_.residual <= problem_.goal; }

  void keep_best() {
    const double now = residual(problem_, forces_);
    if (!(now < solution_.residual)) return;
    solution_.residual = now;
    solution_.forces = forces_;
  }

  void name_undecided(const std::vector<Grip>& a, const std::vector<Grip>& b) {
    solution_.undecided.clear();
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a[i] != b[i]) solution_.undecided.push_back(i);
  }

  const FrictionalProblem& problem_;
  Eigen::VectorXd forces_;       ///< of the last active set
  FrictionalSolution solution_;  ///< with the best forces seen
};

}  // namespace

FrictionalSolution newton(const FrictionalProblem& problem, const Eigen::VectorXd& start) {
  return Newton(problem, start).run();
}

}  // namespace keyblock
