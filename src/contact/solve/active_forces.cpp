// Numbers the unknown forces and selects one of the solvers by their number.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solve/active_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "contact/solve/coupled_forces.hpp"
#include "contact/solve/forces_of_blocks.hpp"

namespace keyblock {
namespace {

// Up to this number of unknowns a dense factorisation is faster than a sparse one.
constexpr std::size_t kMostDense = 48;
// Iterations are faster up to this ratio of contact stiffness to inertia, as in a step of Shi's rules.
constexpr double kGreatestRatio = 100;
// Number of products with the cost of a factorisation, over the square root of the number of blocks.
constexpr double kMostProducts = 3;

}  // namespace

ActiveSet::ActiveSet(const std::vector<ForceLaw>& laws, const std::vector<Grip>& grips) {
  for (std::size_t i = 0; i < grips.size(); ++i) {
    const ForceLaw& law = laws[i];
    const auto n = static_cast<Eigen::Index>(2 * i);
    const auto unknown = static_cast<Eigen::Index>(rows.size());
    const auto add_unknown = [&](Eigen::Index force) {
      columns.push_back({static_cast<Eigen::Index>(rows.size()), 1, 0});
      rows.push_back(force);
    };
    if (is_open(grips[i]))
      columns.push_back({-1, 0, law.least});
    else
      add_unknown(n);
    if (grips[i] == Grip::open) {
      columns.push_back({});
    } else if (grips[i] == Grip::stick || grips[i] == Grip::open_stick) {
      add_unknown(n + 1);
    } else {
      const double sign = grips[i] == Grip::slip_forward ? 1 : -1;
      columns.push_back({unknown, sign * law.friction, sign * law.cohesion});
      slips = slips || law.friction != 0;
    }
  }
}

Eigen::VectorXd ActiveSet::forces(const Eigen::VectorXd& unknowns, double share) const {
  Eigen::VectorXd all(static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Column& column = columns[i];
    all[static_cast<Eigen::Index>(i)] = (share == 0 ? 0 : share * column.given) +
                                        (column.unknown < 0 ? 0 : column.factor * unknowns[column.unknown]) +
                                        (column.coupled == 0 ? 0 : column.coupled * unknowns[columns[i - 1].unknown]);
  }
  return all;
}

Eigen::VectorXd ActiveSet::kept(const Eigen::VectorXd& all) const {
  Eigen::VectorXd entries(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) entries[static_cast<Eigen::Index>(i)] = all[rows[i]];
  return entries;
}

ActiveForces::ActiveForces(const FrictionalProblem& problem, const std::vector<Grip>& grips,
                           const Eigen::VectorXd& added)
    : ActiveForces(problem, ActiveSet(problem.laws, grips), added) {}

ActiveForces::ActiveForces(const FrictionalProblem& problem, ActiveSet set, const Eigen::VectorXd& added)
    : problem_(problem), set_(std::move(set)), added_(added) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(set_.rows.size()));
  const Eigen::VectorXd given = set_.forces(none, 1);
  from_given_ = none;
  if ((given.array() != 0).any()) from_given_ = set_.kept(problem.w * given + added.cwiseProduct(given));
  if (set_.rows.size() <= kMostDense)
    factorise_dense();
  else if (!problem.w.shared().is_none())
    factorise_coupled();
  else if (is_inertia_great())
    iterates_ = true;
  else
    factorise_sparse();
}

ActiveForces::~ActiveForces() = default;

bool ActiveForces::is_regular() const {
  return !sparse_ || sparse_->is_regular();
}

void ActiveForces::factorise_sparse() {
  iterates_ = false;
  sparse_ = std::make_unique<ForcesOfBlocks>(problem_.w, set_, added_);
}

// The dense factorisation also handles a singular matrix, as far as possible.
void ActiveForces::factorise_coupled() {
  coupled_ = std::make_unique<CoupledForces>(problem_.w, set_, added_);
  if (coupled_->is_regular()) return;
  coupled_.reset();
  factorise_dense();
}

void ActiveForces::factorise_dense() {
  const auto size = static_cast<Eigen::Index>(set_.rows.size());
  if (size == 0) return;
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index r = 0; r < size; ++r) {
    const Eigen::Index force = set_.rows[static_cast<std::size_t>(r)];
    const RowThrough row(problem_.w, force);
    for (std::size_t i = 0; i < set_.columns.size(); ++i) {
      const ActiveSet::Column& column = set_.columns[i];
      if (column.unknown < 0) continue;
      const auto other = static_cast<Eigen::Index>(i);
      const double own = other == force ? problem_.w.added()[force] + added_[force] : 0;
      a(r, column.unknown) += column.factor * (row.times(other) + own);
      if (column.coupled != 0) a(r, set_.columns[i - 1].unknown) += column.coupled * row.times(other);
    }
  }
  dense_.compute(a);
}

// Compares the compliance of inertia with that of springs: R = p Δt² / 2m, and its counterpart for soft blocks.
bool ActiveForces::is_inertia_great() const {
  if (!problem_.w.pairs() || problem_.w.pairs()->gave_up()) return false;
  double sum = 0;
  for (const Eigen::Index i : set_.rows) {
    const double spring = problem_.w.added()[i] + added_[i];
    if (!(spring > 0)) return false;
    sum += (problem_.w.diagonal()[i] - problem_.w.added()[i]) / spring;
  }
  return sum <= kGreatestRatio * static_cast<double>(set_.rows.size());
}

std::optional<Eigen::VectorXd> ActiveForces::by_iterations(const Eigen::VectorXd& right, const Eigen::VectorXd& near,
                                                           double goal) const {
  const Eigen::VectorXd springs = set_.kept(problem_.w.added() + added_);
  std::vector<PairStiffness> h(problem_.count());
  double judged = std::numeric_limits<double>::infinity();
  for (std::size_t u = 0; u < set_.rows.size(); ++u) {
    const Eigen::Index row = set_.rows[u];
    PairStiffness& pair = h[static_cast<std::size_t>(row / 2)];
    const double stiffness = 1 / springs[static_cast<Eigen::Index>(u)];
    (row % 2 == 0 ? pair.nn : pair.tt) = stiffness;
    const ActiveSet::Column& across = set_.columns[static_cast<std::size_t>(row + 1 - row % 2)];
    if (row % 2 == 0 && across.unknown == static_cast<Eigen::Index>(u)) pair.tn = across.factor * stiffness;
    if (row % 2 == 0) pair.tn += across.coupled * stiffness;
    const double own = problem_.w.diagonal()[row] - problem_.w.added()[row];
    judged = std::min(judged, problem_.share_of(row) * problem_.compliance()[row] / std::sqrt(own));
  }
  const int most = static_cast<int>(kMostProducts * std::sqrt(static_cast<double>(problem_.w.blocks().count())));
  // A residual r of two blocks changes the force of a pair by G A⁻¹ r over its compliance, at most √(2 W) times the
  // greater norm.
  const PairSystem::Result result =
      problem_.w.pairs()->solve(h, set_.forces(right.cwiseQuotient(springs), 0), set_.forces(set_.kept(near), 0),
                                goal * judged / std::numbers::sqrt2, most);
  if (!result.converged) return std::nullopt;
  return (right - set_.kept(result.rates)).cwiseQuotient(springs);
}

std::optional<Eigen::VectorXd> ActiveForces::solve(const Eigen::VectorXd& b, const Eigen::VectorXd& near, double goal) {
  const Eigen::VectorXd right = -from_given_ - set_.kept(b);
  if (iterates_) {
    if (const auto unknowns = by_iterations(right, near, goal)) return set_.forces(*unknowns, 1);
    problem_.w.pairs()->give_up();
    factorise_sparse();
  }
  if (!is_regular()) return std::nullopt;
  return set_.forces(by_factor(right), 1);
}

Eigen::VectorXd ActiveForces::by_factor(const Eigen::VectorXd& right) const {
  if (right.size() == 0) return right;
  if (sparse_) return sparse_->solve(right);
  return coupled_ ? coupled_->solve(right) : Eigen::VectorXd(dense_.solve(right));
}

}  // namespace keyblock
