// Looks at the rates of all closed springs, and solves only where most of those that matter have turned over.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/stiff_springs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "contact/friction_newton.hpp"
#include "step/step_ties.hpp"

namespace keyblock {
namespace {

// Of the springs whose rates matter at the end, the share that has turned over from which on it is no accident of what moves: on
// walls that ring it is 0.7 to 1, on walls that move below 0.15, on a slope that slides below 0.6.
constexpr double kShareTurnedOver = 0.6;
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
    UnknownsTable way = plus(s_.smooth.q, -1, s_.start.q);
    way *= 1 / s_.dt;
    const Eigen::VectorXd means = normal_rates(s_.smooth.rows, stiff, way);
    // Rows at the end cost more than a look along those of the middle, which see rates of blocks that turn as well.
    if (!ring(turned_over(stiff, means, normal_rates(s_.smooth.rows, stiff, v)))) return v;
    Touches touches;
    for (const std::size_t i : stiff) touches.push_back(s_.touches[i]);
    for (std::size_t i = 0; i < s_.touches.size(); ++i)
      if (s_.closed[i] && s_.smooth.laws[i].normal_compliance == 0) touches.push_back(s_.touches[i]);
    const ContactRows rows = rows_with_points(s_.scene, s_.smooth.q, touches);
    const Eigen::VectorXd at_end = rates(rows, v);
    std::vector<std::size_t> first(stiff.size());
    std::iota(first.begin(), first.end(), std::size_t{0});
    const Turned turned = turned_over(stiff, means, normal_rates(rows, first, v));
    if (!ring(turned)) return v;
    const double goal = kLeft * s_.least_force * s_.dt;
    const Flexibility flexibility = mass_flexibility(s_.scene);
    FrictionalProblem problem{ContactMatrix(rows, flexibility),
                              Eigen::VectorXd::Zero(at_end.size()),
                              std::vector<ForceLaw>(touches.size(), kTie),
                              goal,
                              kLooser * goal,
                              {}};
    problem.laws.insert(problem.laws.end(), s_.scene.held.size(), kHeld);
    for (std::size_t k = 0; k < stiff.size(); ++k) {
      const auto n = static_cast<Eigen::Index>(2 * k);
      problem.w.add_to_diagonal(n, 1 / dashpot(stiff[k]));
      if (turned.which[k]) problem.b[n] = at_end[n] - means[static_cast<Eigen::Index>(k)];
    }
    problem.proximal = Eigen::VectorXd::Zero(at_end.size());  // dashpots make their impulses unique
    const FrictionalSolution made = newton(problem, Eigen::VectorXd::Zero(at_end.size()));
    return made.converged ? plus(v, 1, answer(rows, flexibility, made.forces)) : v;
  }

 private:
  struct Turned {
    std::vector<bool> which;  ///< of the stiff springs
    std::size_t count = 0;
    std::size_t moving = 0;  ///< those whose rate matters
  };

  static Eigen::VectorXd normal_rates(const ContactRows& rows, const std::vector<std::size_t>& touches,
                                      const UnknownsTable& v) {
    const Eigen::VectorXd all = rates(rows, v);
    Eigen::VectorXd normal(static_cast<Eigen::Index>(touches.size()));
    for (std::size_t k = 0; k < touches.size(); ++k)
      normal[static_cast<Eigen::Index>(k)] = all[static_cast<Eigen::Index>(2 * touches[k])];
    return normal;
  }

  Turned turned_over(const std::vector<std::size_t>& stiff, const Eigen::VectorXd& means,
                     const Eigen::VectorXd& at_end) const {
    Turned turned{std::vector<bool>(stiff.size())};
    for (std::size_t k = 0; k < stiff.size(); ++k) {
      const double rate = std::abs(at_end[static_cast<Eigen::Index>(k)]);
      if (lighter(stiff[k]) * rate <= kLeft * s_.least_force * s_.dt) continue;
      ++turned.moving;
      if (std::abs(means[static_cast<Eigen::Index>(k)]) >= kTurnedOver * rate) continue;
      turned.which[k] = true;
      ++turned.count;
    }
    return turned;
  }

  static bool ring(const Turned& turned) {
    return turned.count > 0 &&
           static_cast<double>(turned.count) >= kShareTurnedOver * static_cast<double>(turned.moving);
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

UnknownsTable eased(const StiffSprings& springs, UnknownsTable v) {
  return Ease(springs).of(std::move(v));
}

}  // namespace keyblock
