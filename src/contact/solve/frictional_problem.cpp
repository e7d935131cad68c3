// Computes the natural map and its residual, and applies the two methods in order.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solve/frictional_problem.hpp"

#include <algorithm>

#include "base/loop.hpp"
#include "contact/solve/friction_newton.hpp"
#include "contact/solve/interior_forces.hpp"

namespace keyblock {
double ForceLaw::limit(double normal) const {
  return std::max(0.0, cohesion + friction * normal);
}

NaturalMap natural_map(const std::vector<ForceLaw>& laws, const Eigen::VectorXd& forces, const Eigen::VectorXd& y,
                       const Eigen::VectorXd& compliance) {
  NaturalMap map{forces, std::vector<Grip>(laws.size())};
  for_each_entry(laws.size(), [&](std::size_t i) {
    const ForceLaw& law = laws[i];
    const auto n = static_cast<Eigen::Index>(2 * i);
    const Eigen::Index t = n + 1;
    const double wanted = forces[n] - y[n] / compliance[n];
    const double tangential = forces[t] - y[t] / compliance[t];
    const bool open = wanted <= law.least;
    const double limit = open ? law.limit_open() : law.limit(wanted);
    map.forces[n] = open ? law.least : wanted;
    map.forces[t] = std::clamp(tangential, -limit, limit);
    const Grip sliding = tangential > 0 ? Grip::slip_forward : Grip::slip_backward;
    const bool holds = limit > 0 && std::abs(tangential) <= limit;
    if (open)
      map.grips[i] = limit > 0 ? Grip::open_stick : Grip::open;
    else
      map.grips[i] = holds ? Grip::stick : sliding;
  });
  return map;
}

NaturalMap natural_map(const FrictionalProblem& problem, const Tried& tried) {
  return natural_map(problem.laws, tried.forces, tried.y, problem.compliance());
}

Tried tried(const FrictionalProblem& problem, Eigen::VectorXd forces) {
  Tried made{std::move(forces), {}};
  made.y = problem.w * made.forces + problem.b;
  return made;
}

NaturalMap natural_map(const FrictionalProblem& problem, const Tried& tried, const Proximal& proximal) {
  const Eigen::VectorXd y = tried.y + proximal.weights.cwiseProduct(tried.forces - proximal.reference);
  return natural_map(problem.laws, tried.forces, y, problem.compliance() + proximal.weights);
}

NaturalMap natural_map(const FrictionalProblem& problem, const Eigen::VectorXd& forces) {
  return natural_map(problem, tried(problem, forces));
}

double largest(const FrictionalProblem& problem, const Eigen::VectorXd& change) {
  if (problem.share.size() == 0) return change.cwiseAbs().maxCoeff();
  return change.cwiseAbs().cwiseQuotient(problem.share).maxCoeff();
}

double residual(const FrictionalProblem& problem, const Tried& tried) {
  if (problem.count() == 0) return 0;
  return largest(problem, natural_map(problem, tried).forces - tried.forces);
}

double residual(const FrictionalProblem& problem, const Eigen::VectorXd& forces) {
  return residual(problem, tried(problem, forces));
}

std::size_t worst_pair(const FrictionalProblem& problem, const Eigen::VectorXd& forces) {
  Eigen::Index worst = 0;
  Eigen::VectorXd change = (natural_map(problem, forces).forces - forces).cwiseAbs();
  if (problem.share.size() > 0) change = change.cwiseQuotient(problem.share);
  change.maxCoeff(&worst);
  return static_cast<std::size_t>(worst / 2);
}

// Returns the pairs that the natural map would still change by more than acceptable.
std::vector<std::size_t> unsettled(const FrictionalProblem& problem, const Tried& tried) {
  const auto& [forces, y] = tried;
  const Eigen::VectorXd change = (natural_map(problem, tried).forces - forces).cwiseAbs();
  std::vector<std::size_t> pairs;
  for (std::size_t i = 0; i < problem.count(); ++i) {
    const auto n = static_cast<Eigen::Index>(2 * i);
    const double acceptable = problem.acceptable * problem.share_of(n);
    const bool is_allowed = forces[n] >= problem.laws[i].least - acceptable &&
                            std::abs(forces[n + 1]) <= problem.laws[i].limit(forces[n]) + acceptable;
    const auto is_settled = [&](Eigen::Index k) {
      return change[k] <= acceptable || (is_allowed && std::abs(y[k]) <= problem.gap_tolerance);
    };
    if (!is_settled(n) || !is_settled(n + 1)) pairs.push_back(i);
  }
  return pairs;
}

bool is_acceptable(const FrictionalProblem& problem, const Tried& tried) {
  return unsettled(problem, tried).empty();
}

bool is_acceptable(const FrictionalProblem& problem, const Eigen::VectorXd& forces) {
  return is_acceptable(problem, tried(problem, forces));
}

FrictionalSolution solve(const FrictionalProblem& problem, const Eigen::VectorXd& start, KeptSystem* kept) {
  return solve(problem, tried(problem, start), kept);
}

FrictionalSolution solve(const FrictionalProblem& problem, Tried first, KeptSystem* kept) {
  FrictionalSolution solution{first.forces, residual(problem, first), 0, 0, is_acceptable(problem, first), {}};
  solution = newton(problem, std::move(solution), kept, std::move(first));
  // A detour to the goal itself pays for up to a thousand pairs. It may end at another solution of redundant forces:
  // forces that hold all pairs take none.
  const auto suffices = [&] {
    if (!solution.converged) return false;
    return problem.has_very_many() || (!has_unique_forces(problem) && holds(problem, tried(problem, solution.forces)));
  };
  if (solution.residual > problem.goal && !suffices()) {
    solution = interior_forces(problem, std::move(solution));
    ++solution.fallbacks;
    solution = newton(problem, std::move(solution), kept);
  }
  if (!solution.converged) solution.undecided = unsettled(problem, tried(problem, solution.forces));
  // Otherwise round-off on an open contact would pass for a closed one.
  const Tried last = tried(problem, solution.forces);
  const NaturalMap map = natural_map(problem, last);
  for (std::size_t i = 0; i < problem.count(); ++i) {
    const auto n = static_cast<Eigen::Index>(2 * i);
    const auto end_at = [&](Eigen::Index k, double none) {
      if (std::abs(solution.forces[k] - none) <= problem.no_force) solution.forces[k] = none;
    };
    if (is_open(map.grips[i])) end_at(n, problem.laws[i].least);
    if (map.grips[i] == Grip::open) end_at(n + 1, 0);
  }
  solution.converged = solution.converged && (solution.forces == last.forces ? is_acceptable(problem, last)
                                                                             : is_acceptable(problem, solution.forces));
  return solution;
}

}  // namespace keyblock
