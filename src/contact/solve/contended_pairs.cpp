// A Schur complement, and its small problem by whatever finds it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solve/contended_pairs.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <set>

#include "base/stop.hpp"
#include "contact/solve/active_forces.hpp"

namespace keyblock {
namespace {

// A sweep over few pairs costs next to nothing beside the factor that made their matrix.
constexpr int kFirstPairSweeps = 50;
constexpr int kMostSweeps = 5000;
constexpr int kMostSetsOfPairs = 50;
// Forces of contended pairs are wanted only as well as their states need: this share of the goal of the whole.
constexpr double kShareOfGoal = 0.1;

Eigen::Index normal(std::size_t pair) {
  return static_cast<Eigen::Index>(2 * pair);
}

class Small {
 public:
  Small(const DenseFriction& problem, Eigen::VectorXd start, double goal)
      : p_(problem),
        scale_(problem.w.diagonal()),
        goal_(goal),
        best_(std::move(start)),
        residual_(of(best_).residual) {}

  Eigen::VectorXd solve() {
    newton();
    int sweeps = 0;
    for (int more = kFirstPairSweeps; residual_ > goal_ && sweeps < kMostSweeps; more *= 2) {
      sweep(more);
      sweeps += more;
      newton();
    }
    return std::move(best_);
  }

 private:
  struct Judged {
    NaturalMap map;
    double residual;
  };
  Judged of(const Eigen::VectorXd& forces) const {
    NaturalMap map = natural_map(p_.laws, forces, p_.w * forces + p_.b, scale_);
    const double left = (map.forces - forces).cwiseAbs().maxCoeff();
    return {std::move(map), left};
  }

  void keep(const Eigen::VectorXd& forces, double residual) {
    if (!(residual < residual_)) return;
    best_ = forces;
    residual_ = residual;
  }

  void newton() {
    std::set<std::vector<Grip>> visited;
    Eigen::VectorXd forces = best_;
    for (int i = 0; i < kMostSetsOfPairs && residual_ > goal_; ++i) {
      const std::vector<Grip> grips = of(forces).map.grips;
      if (!visited.insert(grips).second) return;
      const auto next = forces_of(grips);
      if (!next) return;
      forces = *next;
      keep(forces, of(forces).residual);
    }
  }

  std::optional<Eigen::VectorXd> forces_of(const std::vector<Grip>& grips) const {
    const ActiveSet set(p_.laws, grips);
    const auto count = static_cast<Eigen::Index>(set.rows.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd right(count);
    const Eigen::VectorXd given = set.forces(Eigen::VectorXd::Zero(count), 1);
    for (Eigen::Index r = 0; r < count; ++r) {
      const Eigen::Index row = set.rows[static_cast<std::size_t>(r)];
      right[r] = -p_.b[row] - p_.w.row(row).dot(given);
      for (std::size_t i = 0; i < set.columns.size(); ++i)
        if (set.columns[i].unknown >= 0)
          a(r, set.columns[i].unknown) += set.columns[i].factor * p_.w(row, static_cast<Eigen::Index>(i));
    }
    const Eigen::VectorXd forces = set.forces(count > 0 ? Eigen::VectorXd(a.partialPivLu().solve(right)) : right, 1);
    if (!forces.allFinite()) return std::nullopt;
    return forces;
  }

  void sweep(int count) {
    Eigen::VectorXd forces = best_;
    const auto wanted = [&](Eigen::Index i) { return forces[i] - (p_.w.row(i).dot(forces) + p_.b[i]) / scale_[i]; };
    for (int s = 0; s < count; ++s) {
      leave_if_stopped();
      for (std::size_t i = 0; i < p_.laws.size(); ++i) {
        const ForceLaw& law = p_.laws[i];
        const Eigen::Index n = keyblock::normal(i);
        const double normal = wanted(n);
        const bool open = normal <= law.least;
        forces[n] = open ? law.least : normal;
        const double limit = open ? law.limit_open() : law.limit(normal);
        forces[n + 1] = std::clamp(wanted(n + 1), -limit, limit);
      }
    }
    keep(forces, of(forces).residual);
  }

  const DenseFriction& p_;
  Eigen::VectorXd scale_;
  double goal_;
  Eigen::VectorXd best_;
  double residual_;
};

}  // namespace

Eigen::VectorXd solve_dense(const DenseFriction& problem, Eigen::VectorXd start, double goal) {
  return Small(problem, std::move(start), goal).solve();
}

std::vector<Grip> settled_among(const FrictionalProblem& problem, std::vector<Grip> grips,
                                std::span<const std::size_t> pairs, const Eigen::VectorXd& added,
                                const Eigen::VectorXd& b, const Eigen::VectorXd& forces) {
  std::vector<Eigen::Index> rows;
  std::vector<Grip> without = grips;
  DenseFriction small;
  for (const std::size_t pair : pairs) {
    rows.insert(rows.end(), {normal(pair), normal(pair) + 1});
    without[pair] = Grip::open;
    small.laws.push_back(problem.laws[pair]);
  }
  ActiveForces others(problem, without, added);
  auto base = others.solve(b, forces, problem.goal);
  const auto flexibility = others.flexibility(rows);
  if (!base || !flexibility) return grips;
  const Eigen::VectorXd y = problem.w * *base + added.cwiseProduct(*base) + b;
  const auto entries = [&](const Eigen::VectorXd& all) {
    Eigen::VectorXd own(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) own[static_cast<Eigen::Index>(i)] = all[rows[i]];
    return own;
  };
  small.w = *flexibility;
  small.b = entries(y) - small.w * entries(*base);
  const Eigen::VectorXd settled = solve_dense(small, entries(forces), kShareOfGoal * problem.goal);
  const NaturalMap map = natural_map(small.laws, settled, small.w * settled + small.b, small.w.diagonal());
  for (std::size_t i = 0; i < pairs.size(); ++i) grips[pairs[i]] = map.grips[i];
  return grips;
}

}  // namespace keyblock
