// Active set after active set, proximal round after proximal round.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/friction_newton.hpp"

#include <Eigen/LU>
#include <set>

namespace keyblock {
namespace {

// Weight of the proximal term over W_ii: smaller ones cycled on jointed masses, larger ones need more rounds.
constexpr double kProximal = 1e-3;
// Each round shrinks the part of the error that W sees by about kProximal: five reach round-off, the rest is reserve.
constexpr int kMostRounds = 30;
// Active sets of one round; a cycle is found long before.
constexpr int kMostSets = 60;

class Newton {
 public:
  Newton(const FrictionalProblem& problem, const Eigen::VectorXd& start) : problem_(problem) {
    solution_.forces = start;
    close();
  }

  FrictionalSolution run() {
    for (int round = 0; round < kMostRounds && !solution_.converged; ++round) {
      const FrictionalProblem regular = regularised(solution_.forces);
      if (!settle(regular)) break;
    }
    return std::move(solution_);
  }

 private:
  FrictionalProblem regularised(const Eigen::VectorXd& reference) const {
    FrictionalProblem regular = problem_;
    const Eigen::VectorXd added = kProximal * problem_.w.diagonal();
    regular.w.diagonal() += added;
    regular.b -= added.cwiseProduct(reference);
    return regular;
  }

  // False if the active sets go round in a cycle.
  bool settle(const FrictionalProblem& regular) {
    std::set<std::vector<Grip>> visited;
    std::vector<Grip> grips = natural_map(regular, solution_.forces).grips;
    for (int i = 0; i < kMostSets; ++i) {
      visited.insert(grips);
      solution_.forces = forces_for(regular, grips);
      ++solution_.solves;
      close();
      if (solution_.converged) return true;
      const std::vector<Grip> next = natural_map(regular, solution_.forces).grips;
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

  void close() {
    solution_.residual = residual(problem_, solution_.forces);
    solution_.converged = solution_.residual <= problem_.tolerance;
  }

  void name_undecided(const std::vector<Grip>& a, const std::vector<Grip>& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a[i] != b[i]) solution_.undecided.push_back(i);
  }

  const FrictionalProblem& problem_;
  FrictionalSolution solution_;
};

}  // namespace

FrictionalSolution newton(const FrictionalProblem& problem, const Eigen::VectorXd& start) {
  return Newton(problem, start).run();
}

}  // namespace keyblock
