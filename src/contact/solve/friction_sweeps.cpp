// One sweep over all pairs after another, until the residual of the natural map is small.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solve/friction_sweeps.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "base/stop.hpp"

namespace keyblock {
namespace {

// The residual costs as much as a sweep: it is looked at this often.
constexpr int kLook = 10;

// A pair as sweeps read it: what its two forces see of each side, and what the side answers, one after another in
// memory.
struct SweptPair {
  struct Side {
    int first = 0;  // unknown of its element
    int count = 0;
    std::array<double, kMostUnknowns> row{};
    std::array<double, kMostUnknowns> answer{};
  };
  std::array<std::array<Side, 2>, 2> forces;  // normal and tangential; of the vertex and of the edge
};

// y of one force after another, with what the elements answer kept up to date.
class Sweep {
 public:
  Sweep(const FrictionalProblem& problem, Eigen::VectorXd forces) : p_(problem), forces_(std::move(forces)) {
    const Table<ElementIndex, UnknownBlock>& blocks = p_.w.flexibility().blocks;
    Table<ElementIndex, int> first;
    int unknowns = 0;
    for (const UnknownBlock& block : blocks) {
      first.push_back(unknowns);
      unknowns += static_cast<int>(block.rows());
    }
    answer_ = Eigen::VectorXd::Zero(unknowns);
    pairs_.resize(p_.count());
    const auto fill = [&](SweptPair::Side& side, ElementIndex e, const ContactRow::Row& row) {
      side.first = first[e];
      side.count = static_cast<int>(row.size());
      const ContactRow::Row answer = row * blocks[e];
      std::copy(row.data(), row.data() + row.size(), side.row.begin());
      std::copy(answer.data(), answer.data() + answer.size(), side.answer.begin());
    };
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      for (const std::size_t k : {0U, 1U}) {
        const ContactRow& row = p_.w.row(static_cast<Eigen::Index>(2 * i + k));
        auto& sides = pairs_[i].forces[k];
        fill(sides[0], row.vertex_element, row.of_vertex);
        fill(sides[1], row.edge_element, row.of_edge);
        add(sides, forces_[static_cast<Eigen::Index>(2 * i + k)]);
      }
  }

  const Eigen::VectorXd& forces() const { return forces_; }

  void once() {
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const ForceLaw& law = p_.laws[i];
      const auto n = static_cast<Eigen::Index>(2 * i);
      const double normal = wanted(i, 0);
      const bool open = normal <= law.least;
      put(i, 0, open ? law.least : normal);
      const double limit = open ? law.limit_open() : law.limit(normal);
      if (limit > 0 || forces_[n + 1] != 0) put(i, 1, std::clamp(wanted(i, 1), -limit, limit));
    }
  }

 private:
  double wanted(std::size_t pair, std::size_t k) const {
    const auto i = static_cast<Eigen::Index>(2 * pair + k);
    double y = p_.b[i] + p_.w.added()[i] * forces_[i];
    for (const SweptPair::Side& side : pairs_[pair].forces[k])
      for (int u = 0; u < side.count; ++u) y += side.row[static_cast<std::size_t>(u)] * answer_[side.first + u];
    if (!p_.w.shared().is_none()) y += p_.w.shared().rate(i, forces_);
    return forces_[i] - y / p_.w.diagonal()[i];
  }
  void put(std::size_t pair, std::size_t k, double force) {
    double& now = forces_[static_cast<Eigen::Index>(2 * pair + k)];
    const double change = force - now;
    if (change == 0) return;
    now = force;
    add(pairs_[pair].forces[k], change);
  }
  void add(const std::array<SweptPair::Side, 2>& sides, double force) {
    for (const SweptPair::Side& side : sides)
      for (int u = 0; u < side.count; ++u) answer_[side.first + u] += force * side.answer[static_cast<std::size_t>(u)];
  }

  const FrictionalProblem& p_;
  Eigen::VectorXd forces_;
  std::vector<SweptPair> pairs_;
  Eigen::VectorXd answer_;  ///< of all unknowns, element after element
};

}  // namespace

FrictionalSolution sweep(const FrictionalProblem& problem, FrictionalSolution solution, int most_sweeps) {
  Sweep sweeps(problem, solution.forces);
  solution.converged = is_acceptable(problem, solution.forces);
  for (int i = 1; i <= most_sweeps && !solution.converged; ++i) {
    leave_if_stopped();
    sweeps.once();
    ++solution.sweeps;
    if (i % kLook != 0 && i != most_sweeps) continue;
    const double now = residual(problem, sweeps.forces());
    if (i < most_sweeps && now >= solution.residual) continue;
    solution.residual = now;
    solution.forces = sweeps.forces();
    solution.converged = is_acceptable(problem, solution.forces);
  }
  return solution;
}

}  // namespace keyblock
