// Sums the terms of a step rule, evaluates forces and factorises the tangent of each body; see cover_equations.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/bodies/cover_equations.hpp"

#include <algorithm>
#include <set>

#include "step/bodies/linear_static.hpp"

namespace keyblock {
namespace {

Eigen::VectorXd known_of_covers(const StepSum& sum, const CoverMotion& start) {
  return sum.velocity * start.v + sum.acceleration * start.a;
}

/// Marks bodies whose tangent is not symmetric. If unknowns depend on each other, none is marked, because LU fails on a
/// singular matrix.
std::vector<bool> whole_tangents(const ElasticBodies& bodies) {
  const auto& functions = bodies.rigid.functions();
  std::vector<bool> is_whole(functions.size());
  if (definiteness_of(bodies.continuum.functions) == Definiteness::semidefinite) return is_whole;
  const std::set<int> of_points = bodies.yield.functions_of_whole_tangents();
  for (std::size_t body = 0; body < functions.size(); ++body)
    is_whole[body] = std::ranges::any_of(functions[body], [&](int f) { return of_points.contains(f); });
  return is_whole;
}

std::optional<WholeSystem> whole_system(const ElasticBodies& bodies) {
  if (std::ranges::count(whole_tangents(bodies), true) == 0) return std::nullopt;
  return WholeSystem(bodies.mass);
}

PartFactors factors_of(const ElasticBodies& bodies, const std::optional<WholeSystem>& whole) {
  const Definiteness definiteness = definiteness_of(bodies.continuum.functions);
  if (!whole) return {bodies.mass, bodies.rigid.functions(), definiteness};
  return {bodies.mass, *whole, bodies.rigid.functions(), whole_tangents(bodies), definiteness};
}

}  // namespace

CoverEquations::CoverEquations(const ElasticBodies& bodies)
    : bodies_(bodies), tangent_(bodies.mass), whole_(whole_system(bodies)), factors_(factors_of(bodies, whole_)) {}

void CoverEquations::begin(const CoverMotion& start, const Eigen::VectorXd& load, const StepRule& rule, double dt) {
  rule_ = rule;
  const bool is_damped = rule.damping.increment != 0 || rule.damping.velocity != 0 || rule.damping.acceleration != 0;
  weights_ = {rule.stiffness, is_damped && !bodies_.stiffness_damping.empty() ? 1 / dt : 0, rule.inertia.increment,
              bodies_.has_mass_damping ? rule.damping.increment : 0};
  of_strain_rate_.clear();
  if (weights_.strain_rate != 0)
    for (const double b : bodies_.stiffness_damping) of_strain_rate_.push_back(b / dt);
  start_ = start.q;
  points_ = start.points;
  known_inertia_ = known_of_covers(rule.inertia, start);
  if (bodies_.has_mass_damping) known_damping_ = known_of_covers(rule.damping, start);
  load_ = load;
  known_velocity_ = known_of_covers(rule.end_velocity, start);
  known_acceleration_ = known_of_covers(rule.end_acceleration, start);
}

bool CoverEquations::has_factor() const {
  return is_factorised_ && factor_weights_ == weights_;
}

void CoverEquations::linearise(const Eigen::VectorXd& increment) {
  evaluate(increment);
  tangent_.clear();
  tangent_.add_scaled(weights_.mass, bodies_.mass);
  if (bodies_.has_mass_damping) tangent_.add_scaled(weights_.damping, bodies_.mass_damping);
  tangent_.add_scaled(weights_.force, bodies_.ghost);
  tangent_.add_scaled(weights_.force, bodies_.supports);
  const Eigen::VectorXd end = start_ + increment;
  bodies_.elasticity.add_tangent(start_, end, weights_.force, of_strain_rate_, 1, tangent_);
  if (whole_) whole_->clear();
  bodies_.yield.add_tangent_of_step(way_to(end), tangent_, whole_ ? &*whole_ : nullptr);
  if (whole_) whole_->add(tangent_);
  is_factorised_ = false;
  factors_.factorise(tangent_, whole_ ? &*whole_ : nullptr);
  is_factorised_ = true;
  factor_weights_ = weights_;
}

// Inertia is multiplied by M after its terms are summed: terms of steady motion cancel in the sum, not between forces.
void CoverEquations::evaluate(const Eigen::VectorXd& increment) {
  increment_ = increment;
  const Eigen::VectorXd end = start_ + increment;
  Eigen::VectorXd inertia = bodies_.mass.times(weights_.mass * increment + known_inertia_);
  if (bodies_.has_mass_damping) inertia += bodies_.mass_damping.times(weights_.damping * increment + known_damping_);
  residual_ = inertia + bodies_.force(way_to(end)) - load_;
}

CoverMotion CoverEquations::end(const Eigen::VectorXd& increment) const {
  CoverMotion end{start_ + increment, rule_.end_velocity.increment * increment + known_velocity_,
                  rule_.end_acceleration.increment * increment + known_acceleration_, points_};
  if (!bodies_.yield.is_empty()) end.points = bodies_.yield.after(end.q, points_);
  if (definiteness_of(bodies_.continuum.functions) == Definiteness::semidefinite) {
    end.v = solve(tangent_.times(end.v));
    end.a = solve(tangent_.times(end.a));
  }
  return end;
}

}  // namespace keyblock
