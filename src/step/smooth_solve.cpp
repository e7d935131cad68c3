// Relinearises gaps and rows about the last estimate until the estimate stays.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/smooth_solve.hpp"

#include <algorithm>
#include <cmath>

#include "contact/gap.hpp"
#include "step/step_equations.hpp"

namespace keyblock {
namespace {

// Increments that change by less than this share of block size are settled: a hundred times round-off of a position.
constexpr double kSettled = 1e-12;
// One to three rounds are usual. What still moves after the last one, by less than the second figure, is left as a gap error
// of that size for the next step to close; more is a failure.
constexpr int kMostRounds = 8;
constexpr double kTolerable = 1e-6;

class SmoothSolve {
 public:
  SmoothSolve(const StandardScene& scene, const Motion& start, const UnknownsTable& loads, const Touches& touches,
              const ForceTolerance& tolerance, double dt)
      : scene_(scene),
        start_(start),
        touches_(touches),
        tolerance_(tolerance),
        dt_(dt),
        rule_(step_rule(scene.settings.standard, dt)) {
    for (ElementIndex e : indices(scene.bodies)) prepare(e, loads[e]);
  }

  SmoothMotion run() {
    UnknownsTable increments = free_;
    result_.converged = true;
    result_.forces = remembered_forces();
    double change = touches_.empty() ? 0 : 1;
    for (int round = 0; round < kMostRounds && change > kSettled && result_.converged; ++round) {
      UnknownsTable next = increments_about(increments);
      change = greatest_change(increments, next);
      increments = std::move(next);
    }
    result_.converged = result_.converged && change <= kTolerable;
    result_.q = plus(start_.q, 1, increments);
    result_.v = plus(known_velocity_, rate(), increments);
    return std::move(result_);
  }

 private:
  void prepare(ElementIndex e, const Unknowns& load) {
    StepEquations equations = step_equations(scene_.bodies[e], start_.q[e], start_.v[e], load, rule_);
    inverse_.push_back(std::move(equations.inverse));
    free_.push_back(std::move(equations.free));
    known_velocity_.push_back(std::move(equations.known_velocity));
  }

  // Slip velocities are counted as increments: the displacement that alone would give them.
  double rate() const { return rule_.end_velocity.increment; }

  UnknownsTable increments_about(const UnknownsTable& estimate) {
    ContactRows rows = contact_rows(scene_.model, scene_.reference, plus(start_.q, 0.5, estimate), touches_);
    const FrictionalSolution solution = solve(problem_about(rows, estimate), result_.forces);
    result_.forces = solution.forces;
    result_.solves += solution.solves + solution.sweeps;
    result_.residual = solution.residual;
    result_.converged = solution.converged;
    result_.undecided = solution.undecided;
    UnknownsTable increments = plus(free_, 1, answer(rows, inverse_, solution.forces));
    result_.rows = std::move(rows);
    return increments;
  }

  FrictionalProblem problem_about(const ContactRows& rows, const UnknownsTable& estimate) const {
    const Table<VertexIndex, Point> end = vertices_at(scene_.model, scene_.reference, plus(start_.q, 1, estimate));
    const Eigen::VectorXd from_estimate = rates(rows, plus(free_, -1, estimate));
    const Eigen::VectorXd slip = rates(rows, plus(free_, 1 / rate(), known_velocity_));
    FrictionalProblem problem{contact_matrix(rows, inverse_), slip, friction_of(scene_, touches_), tolerance_.goal,
                              tolerance_.acceptable};
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      const auto n = static_cast<Eigen::Index>(2 * i);
      problem.b[n] = gap_of(touches_[i], end) + from_estimate[n];
      if (scene_.has_springs()) add_springs(problem, n, touches_[i]);
    }
    return problem;
  }

  // The tangential spring is stretched by dt times the velocity at the end of the step: a spring too stiff for the step then
  // brings its point to rest, where the displacement of the step would turn the velocity over in each step.
  void add_springs(FrictionalProblem& problem, Eigen::Index n, const Touch& touch) const {
    problem.w(n, n) += 1 / scene_.normal_stiffness();
    const double of_stretch = 1 / (rate() * dt_);
    problem.w(n + 1, n + 1) += of_stretch / scene_.tangential_stiffness();
    const auto memory = start_.closed.find(touch);
    if (memory != start_.closed.end()) problem.b[n + 1] += of_stretch * memory->second.stretch;
  }

  Eigen::VectorXd remembered_forces() const {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * touches_.size()));
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      const auto memory = start_.closed.find(touches_[i]);
      if (memory == start_.closed.end()) continue;
      forces[static_cast<Eigen::Index>(2 * i)] = memory->second.normal;
      forces[static_cast<Eigen::Index>(2 * i + 1)] = memory->second.tangential;
    }
    return forces;
  }

  // Relative to block size; rotation and strain are relative as they are.
  double greatest_change(const UnknownsTable& a, const UnknownsTable& b) const {
    double greatest = 0;
    for (ElementIndex e : indices(a)) {
      if (a[e].size() == 0) continue;
      const Unknowns change = (a[e] - b[e]).cwiseAbs();
      greatest = std::max(
          {greatest, change.head<2>().maxCoeff() / scene_.bodies[e].size, change.tail(change.size() - 2).maxCoeff()});
    }
    return greatest;
  }

  const StandardScene& scene_;
  const Motion& start_;
  const Touches& touches_;
  ForceTolerance tolerance_;
  double dt_;
  StepRule rule_;
  Table<ElementIndex, UnknownBlock> inverse_;
  UnknownsTable free_;            ///< increments without contact
  UnknownsTable known_velocity_;  ///< what the increments leave of the velocities at the end
  SmoothMotion result_;
};

}  // namespace

SmoothMotion smooth_solve(const StandardScene& scene, const Motion& start, const UnknownsTable& loads,
                          const Touches& touches, const ForceTolerance& tolerance, double dt) {
  return SmoothSolve(scene, start, loads, touches, tolerance, dt).run();
}

}  // namespace keyblock
