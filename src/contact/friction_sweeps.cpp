// One sweep over all pairs after another, until the residual of the natural map is small.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/friction_sweeps.hpp"

#include <algorithm>

namespace keyblock {
namespace {

// The residual costs as much as a sweep: it is looked at this often.
constexpr int kLook = 10;

// y of one force after another, with what the elements answer kept up to date.
class Sweep {
 public:
  Sweep(const FrictionalProblem& problem, Eigen::VectorXd forces) : p_(problem), forces_(std::move(forces)) {
    ContactRows rows;
    for (Eigen::Index i = 0; i < forces_.size(); ++i) rows.push_back(p_.w.row(i));
    answer_ = answer_of_blocks(rows, p_.w.flexibility().blocks, forces_);
  }

  const Eigen::VectorXd& forces() const { return forces_; }

  void once() {
    for (std::size_t i = 0; i < p_.count(); ++i) {
      const ForceLaw& law = p_.laws[i];
      const auto n = static_cast<Eigen::Index>(2 * i);
      const double normal = wanted(n);
      const bool open = normal <= law.least;
      put(n, open ? law.least : normal);
      const double limit = open ? law.limit_open() : law.limit(normal);
      put(n + 1, std::clamp(wanted(n + 1), -limit, limit));
    }
  }

 private:
  double wanted(Eigen::Index i) const {
    const ContactRow& row = p_.w.row(i);
    const double y = p_.b[i] + p_.w.added()[i] * forces_[i] +
                     row.of_vertex.dot(answer_[row.vertex_element].transpose()) +
                     row.of_edge.dot(answer_[row.edge_element].transpose()) + p_.w.covers().rate(i, forces_);
    return forces_[i] - y / p_.w.diagonal()[i];
  }
  void put(Eigen::Index i, double force) {
    const ContactRow& row = p_.w.row(i);
    const double change = force - forces_[i];
    if (change == 0) return;
    forces_[i] = force;
    answer_[row.vertex_element] += change * (p_.w.flexibility().blocks[row.vertex_element] * row.of_vertex.transpose());
    answer_[row.edge_element] += change * (p_.w.flexibility().blocks[row.edge_element] * row.of_edge.transpose());
  }

  const FrictionalProblem& p_;
  Eigen::VectorXd forces_;
  UnknownsTable answer_;
};

}  // namespace

FrictionalSolution sweep(const FrictionalProblem& problem, FrictionalSolution solution, int most_sweeps) {
  Sweep sweeps(problem, solution.forces);
  solution.converged = is_acceptable(problem, solution.forces);
  for (int i = 1; i <= most_sweeps && !solution.converged; ++i) {
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
