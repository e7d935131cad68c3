// Active set after active set, proximal round after proximal round.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/friction_newton.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "contact/active_forces.hpp"

namespace keyblock {
namespace {

// Weights of the proximal term over the compliance of a force, tried in turn: small ones need few rounds but cycle on jointed masses.
constexpr std::array<double, 3> kProximal{1e-3, 1e-2, 1e-1};
// Few touches are solved further with this one where those above stopped short of the goal: between a light block and a heavy one
// W_ii is that of the light one, and a share of it yields more than the heavy one does.
constexpr double kFine = 1e-8;
constexpr std::size_t kFew = 24;
// Each round shrinks the part of the error that W sees by about the weight: five reach round-off at 1e-3, the rest is reserve.
constexpr int kMostRounds = 30;
// An acceptable residual that a round improves by less than this is left as it is.
constexpr double kProgress = 0.5;
// Active sets of one round; a cycle is found long before.
constexpr int kMostSets = 60;
// Sets one after another whose residuals differ by less than the second figure end a round: what still changes is smaller than the
// residual, as are the forces of touches that open and close without end where nothing presses them.
constexpr int kIdleSets = 4;
constexpr double kSame = 1e-3;
// Residual that iterations may leave: over the goal, and of an active set that may not be the last one, over the residual
// that it starts with.
constexpr double kInner = 0.3;
constexpr double kForcing = 0.001;

class Newton {
 public:
  Newton(const FrictionalProblem& problem, FrictionalSolution so_far)
      : problem_(problem), solution_(std::move(so_far)) {}

  FrictionalSolution run() {
    for (std::size_t attempt = 0; attempt < kProximal.size(); ++attempt) {
      if (attempt == 0 ? is_solved() : solution_.converged) break;
      weights_ = kProximal[attempt] * problem_.compliance();
      if (attempt == 0 && problem_.proximal.size() > 0) weights_ = chosen_weights();
      try_weights();
    }
    if (!is_solved() && solution_.converged && problem_.count() <= kFew && problem_.proximal.size() == 0) {
      weights_ = kFine * problem_.compliance();
      try_weights();
    }
    return std::move(solution_);
  }

 private:
  // Round after round with these weights, from the best forces seen.
  void try_weights() {
    system_.reset();
    tried_ = tried(problem_, solution_.forces);
    tried_residual_ = solution_.residual;
    for (int round = 0; round < kMostRounds && !is_solved(); ++round) {
      const double before = solution_.residual;
      if (!settle({weights_, tried_.forces})) break;
      if ((solution_.converged || is_idle_) && solution_.residual > kProgress * before) break;
    }
  }

  // Solves with the proximal term; false if the active sets go round in a cycle or leave forces open.
  bool settle(const Proximal& proximal) {
    const Eigen::VectorXd right = problem_.b - proximal.weights.cwiseProduct(proximal.reference);
    std::set<std::vector<Grip>> visited;
    std::vector<Grip> grips = natural_map(problem_, tried_, proximal).grips;
    bool is_loose = true;
    int idle = 0;
    is_idle_ = false;
    for (int i = 0; i < kMostSets; ++i) {
      const double before = tried_residual_;
      visited.insert(grips);
      factorise(grips);
      const double left = is_loose && system_->iterates() ? kForcing * tried_residual_ : 0;
      auto forces = system_->solve(right, tried_.forces, std::max(kInner * problem_.goal, left));
      if (!forces) return false;
      tried_ = tried(problem_, *std::move(forces));
      keep_best();
      if (is_solved()) return true;
      idle = std::abs(tried_residual_ - before) <= kSame * before ? idle + 1 : 0;
      is_idle_ = idle >= kIdleSets && !(is_loose && system_->iterates());
      const std::vector<Grip> next = natural_map(problem_, tried_, proximal).grips;
      if (next == grips || is_idle_) return true;
      if (visited.contains(next) && is_loose && system_->iterates()) {
        is_loose = false;  // it may be errors that go round
        visited.clear();
        idle = 0;
      } else if (visited.contains(next)) {
        name_undecided(grips, next);
        return false;
      }
      grips = next;
    }
    return false;
  }

  // Those of the problem, with ours where neither they nor a compliance make a force unique.
  Eigen::VectorXd chosen_weights() const {
    Eigen::VectorXd weights = problem_.proximal;
    for (Eigen::Index i = 0; i < weights.size(); ++i)
      if (weights[i] + problem_.w.added()[i] == 0) weights[i] = weights_[i];
    return weights;
  }

  void factorise(const std::vector<Grip>& grips) {
    if (system_ && grips == factorised_) return;
    system_.emplace(problem_, grips, weights_);
    factorised_ = grips;
    ++solution_.solves;
  }

  bool is_solved() const { return solution_.residual <= problem_.goal; }

  void keep_best() {
    tried_residual_ = residual(problem_, tried_);
    if (!(tried_residual_ < solution_.residual)) return;
    const bool is_good = is_acceptable(problem_, tried_);
    if (solution_.converged && !is_good) return;
    solution_.residual = tried_residual_;
    solution_.forces = tried_.forces;
    solution_.converged = is_good;
  }

  void name_undecided(const std::vector<Grip>& a, const std::vector<Grip>& b) {
    solution_.undecided.clear();
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a[i] != b[i]) solution_.undecided.push_back(i);
  }

  const FrictionalProblem& problem_;
  FrictionalSolution solution_;  ///< with the best forces seen
  Eigen::VectorXd weights_;      ///< of the proximal term
  Tried tried_;                  ///< forces of the last active set
  double tried_residual_ = 0;    ///< their residual
  bool is_idle_ = false;         ///< the last round ended with sets that came to the same
  std::optional<ActiveForces> system_;
  std::vector<Grip> factorised_;
};

}  // namespace

FrictionalSolution newton(const FrictionalProblem& problem, const Eigen::VectorXd& start) {
  FrictionalSolution so_far;
  const Tried first = tried(problem, start);
  so_far.forces = start;
  so_far.residual = residual(problem, first);
  so_far.converged = is_acceptable(problem, first);
  return newton(problem, std::move(so_far));
}

FrictionalSolution newton(const FrictionalProblem& problem, FrictionalSolution so_far) {
  return Newton(problem, std::move(so_far)).run();
}

}  // namespace keyblock
