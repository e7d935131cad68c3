// Sums of a rule, forces, one factor a body; see cover_equations.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/cover_equations.hpp"

#include <algorithm>

#include "step/linear_static.hpp"

namespace keyblock {
namespace {

Eigen::VectorXd known(const StepSum& sum, const CoverMotion& start) {
  return sum.velocity * start.v + sum.acceleration * start.a;
}

}  // namespace

CoverEquations::CoverEquations(const CoverBodies& bodies)
    : bodies_(bodies),
      tangent_(bodies.mass),
      factors_(tangent_, bodies.rigid.functions(), definiteness_of(bodies.continuum.functions)) {}

void CoverEquations::begin(const CoverMotion& start, const Eigen::VectorXd& load, const StepRule& rule, double dt) {
  const CoverDamping& damping = bodies_.damping;
  rule_ = rule;
  strain_weight_ = rule.stiffness + damping.stiffness / dt;
  mass_weight_ = rule.inertia.increment + damping.mass * rule.damping.increment;
  start_ = start.q;
  known_inertia_ = known(rule.inertia, start) + damping.mass * known(rule.damping, start);
  load_ = load;
  known_velocity_ = known(rule.end_velocity, start);
  known_acceleration_ = known(rule.end_acceleration, start);
}

void CoverEquations::linearise(const Eigen::VectorXd& increment) {
  evaluate(increment);
  tangent_.clear();
  tangent_.add_scaled(mass_weight_, bodies_.mass);
  tangent_.add_scaled(rule_.stiffness, bodies_.constant);
  bodies_.elasticity.add_tangent(start_, start_ + increment, strain_weight_, 1, tangent_);
  factors_.factorise(tangent_);
}

// Inertia is multiplied out after its sum is taken: what a steady motion has of it cancels in the sum, not in the forces.
void CoverEquations::evaluate(const Eigen::VectorXd& increment) {
  increment_ = increment;
  const Eigen::VectorXd inertia = bodies_.mass.times(mass_weight_ * increment + known_inertia_);
  const Eigen::VectorXd elastic = bodies_.elasticity.force(start_, start_ + increment, strain_weight_);
  const Eigen::VectorXd constant = bodies_.constant.times(start_ + rule_.stiffness * increment);
  residual_ = inertia + elastic + constant - load_;
  force_scale_ = std::max({inertia.norm(), elastic.norm(), constant.norm(), load_.norm()});
}

CoverMotion CoverEquations::end(const Eigen::VectorXd& increment) const {
  return {start_ + increment, rule_.end_velocity.increment * increment + known_velocity_,
          rule_.end_acceleration.increment * increment + known_acceleration_};
}

}  // namespace keyblock
