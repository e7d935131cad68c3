// Looks at the rates of all closed springs, and solves only where one has turned over.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/stiff_springs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/friction_newton.hpp"

namespace keyblock {
namespace {

// ω dt of a spring from which on its rate turns over; a rate whose mean over the step is a smaller share than this of that at
// its end has done so: one that grows from rest has half.
constexpr double kFollowed = 2;
constexpr double kTurnedOver = 0.4;
// Of the springs whose rates matter at the end, the share that has turned over from which on it is no accident of what moves: on
// walls that ring it is above 0.7, on walls that move below 0.15.
constexpr double kMany = 0.25;
// What may be turned over, and what the dashpots may leave, over the impulse of the least force in the step: the forces change by
// twice as much.
constexpr double kLeft = 0.1;
constexpr double kLooser = 1e4;

class Ease {
 public:
  explicit Ease(const StiffSprings& springs) : s_(springs) {}

  UnknownsTable of(UnknownsTable v) const {
    const std::vector<std::size_t> stiff = stiff_ones();
    if (stiff.empty()) return v;
    const ContactRows& rows = s_.smooth.rows;
    UnknownsTable way = plus(s_.smooth.q, -1, s_.start.q);
    way *= 1 / s_.dt;
    const Eigen::VectorXd at_end = rates(rows, v);
    const Eigen::VectorXd means = rates(rows, way);
    std::size_t moving = 0;
    std::size_t turned_over = 0;
    for (const std::size_t i : stiff) {
      const auto n = static_cast<Eigen::Index>(2 * i);
      if (lighter(i) * std::abs(at_end[n]) <= kLeft * s_.least_force * s_.dt) continue;
      ++moving;
      if (std::abs(means[n]) < kTurnedOver * std::abs(at_end[n])) ++turned_over;
    }
    if (turned_over == 0 || static_cast<double>(turned_over) < kMany * static_cast<double>(moving)) return v;
    return plus(v, 1, by_dashpots(stiff, at_end - means));
  }

 private:
  // What the dashpots of these springs add to the velocities; `over`: rates of all touches over what they are to be. None where
  // no impulses are found.
  UnknownsTable by_dashpots(const std::vector<std::size_t>& stiff, const Eigen::VectorXd& over) const {
    const auto size = static_cast<Eigen::Index>(2 * stiff.size());
    const double goal = kLeft * s_.least_force * s_.dt;
    ContactRows rows;
    rows.reserve(2 * stiff.size());
    Eigen::VectorXd b(size);
    for (const std::size_t i : stiff)
      for (const std::size_t row : {2 * i, 2 * i + 1}) {
        b[static_cast<Eigen::Index>(rows.size())] = over[static_cast<Eigen::Index>(row)];
        rows.push_back(s_.smooth.rows[row]);
      }
    const Flexibility flexibility = mass_flexibility(s_.scene);
    FrictionalProblem problem{
        ContactMatrix(rows, flexibility), b, std::vector<ForceLaw>(stiff.size(), kTie), goal, kLooser * goal, {}};
    for (std::size_t k = 0; k < stiff.size(); ++k)
      problem.w.add_to_diagonal(static_cast<Eigen::Index>(2 * k), 1 / dashpot(stiff[k]));
    problem.proximal = Eigen::VectorXd::Zero(size);  // dashpots make the impulses unique
    const FrictionalSolution made = newton(problem, Eigen::VectorXd::Zero(size));
    return answer(rows, flexibility, made.converged ? made.forces : Eigen::VectorXd::Zero(size));
  }

  double dashpot(std::size_t i) const { return s_.dt * s_.dt / s_.smooth.laws[i].normal_compliance; }

  // Mass of the lighter body at a touch; infinite between two that are fixed.
  double lighter(std::size_t i) const {
    double least = std::numeric_limits<double>::infinity();
    for (const VertexIndex vertex : {s_.touches[i].vertex, s_.touches[i].start}) {
      const UnknownBlock& mass = s_.scene.bodies[element(vertex)].mass;
      if (mass.rows() > 0) least = std::min(least, mass(0, 0));
    }
    return least;
  }

  ElementIndex element(VertexIndex vertex) const { return s_.scene.model.vertices[vertex].element; }

  // Closed springs of a block all act on it: ω² is the sum of their stiffness over its mass.
  std::vector<std::size_t> stiff_ones() const {
    Table<ElementIndex, double> stiffness(s_.scene.bodies.size(), 0.0);
    std::vector<std::size_t> springs;
    for (std::size_t i = 0; i < s_.touches.size(); ++i) {
      const ElementIndex a = element(s_.touches[i].vertex);
      const ElementIndex b = element(s_.touches[i].start);
      const double compliance = s_.smooth.laws[i].normal_compliance;
      const bool is_on_covers = s_.scene.reference.is_on_covers(a) || s_.scene.reference.is_on_covers(b);
      if (!s_.closed[i] || compliance == 0 || is_on_covers) continue;
      springs.push_back(i);
      stiffness[a] += 1 / compliance;
      stiffness[b] += 1 / compliance;
    }
    const auto is_stiff = [&](ElementIndex e) {
      const UnknownBlock& mass = s_.scene.bodies[e].mass;
      return mass.rows() > 0 && stiffness[e] * s_.dt * s_.dt > kFollowed * kFollowed * mass(0, 0);
    };
    std::erase_if(springs, [&](std::size_t i) {
      return !is_stiff(element(s_.touches[i].vertex)) && !is_stiff(element(s_.touches[i].start));
    });
    return springs;
  }

  const StiffSprings& s_;
};

}  // namespace

UnknownsTable with_stiff_springs_at_ease(const StiffSprings& springs, UnknownsTable v) {
  return Ease(springs).of(std::move(v));
}

}  // namespace keyblock
