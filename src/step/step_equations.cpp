// Each integrator is one function from its parameters to a rule.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/step_equations.hpp"

#include <Eigen/Cholesky>

namespace keyblock {
namespace {

StepRule weighted(double velocity_weight, double force_weight, double dt) {
  const double mass = 1 / (velocity_weight * dt * dt);
  const double rate = 1 / (velocity_weight * dt);
  return {{mass, -mass * dt, 0}, {1 / dt, 0, 0}, force_weight, {rate, -(1 - velocity_weight) / velocity_weight, 0}};
}

}  // namespace

StepRule step_rule(const StandardChoices& choices, double dt) {
  return weighted(choices.velocity_weight, choices.force_weight, dt);
}

StepEquations step_equations(const Body& body, const Unknowns& q0, const Unknowns& v0, const Unknowns& load,
                             const StepRule& rule) {
  const UnknownBlock a =
      rule.inertia.increment * body.mass + rule.stiffness * body.stiffness + rule.damping.increment * body.damping;
  const Unknowns r = load + body.initial_stress - body.stiffness * q0 - body.mass * (rule.inertia.velocity * v0);
  StepEquations equations{a, {}, rule.end_velocity.velocity * v0};
  if (a.rows() > 0) equations.inverse = a.llt().solve(UnknownBlock::Identity(a.rows(), a.cols()));
  equations.free = equations.inverse * r;
  return equations;
}

}  // namespace keyblock
