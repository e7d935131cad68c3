// Turns the parameters of each integrator into a step rule.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/bodies/integrator.hpp"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

// (1/30)². Statics judges forces as over a step of 30 over the slowest frequency of a body: nearly elastic, not quite
// free.
constexpr double kJudging = 1.0 / 900;

StepSum scaled(const StepSum& sum, double by) {
  return {by * sum.increment, by * sum.velocity, by * sum.acceleration};
}

StepRule weighted(const StandardChoices& choices, double dt) {
  const double by = 1 / (choices.velocity_weight * dt);
  const StepSum acceleration{by / dt, -by, 0};
  const StepSum end{by, -(1 - choices.velocity_weight) / choices.velocity_weight, 0};
  const bool follows_rate = choices.strain_damping == StrainDamping::critical && choices.impact == ImpactLaw::jump;
  return {.inertia = acceleration,
          .damping = {1 / dt, 0, 0},
          .stiffness = choices.force_weight,
          .strain = follows_rate ? scaled(end, dt) : StepSum{choices.force_weight, 0, 0},
          .strain_rate = follows_rate ? end : StepSum{1 / dt, 0, 0},
          .load_time = 0.5,
          .end_velocity = end,
          .end_acceleration = acceleration,
          .velocity_lead = (choices.velocity_weight - 0.5) * dt,
          .error_of_change = 1.0 / 12 + (choices.force_weight - 0.5) / 2,
          .error_of_acceleration = choices.velocity_weight - 0.5};
}

StepRule newmark(double beta, double gamma, double dt) {
  const StepSum acceleration{1 / (beta * dt * dt), -1 / (beta * dt), -(0.5 - beta) / beta};
  const StepSum velocity{gamma / (beta * dt), 1 - gamma / beta, (1 - gamma / (2 * beta)) * dt};
  return {.inertia = acceleration,
          .damping = velocity,
          .strain_rate = velocity,
          .end_velocity = velocity,
          .end_acceleration = acceleration,
          .acceleration_lead = (beta - gamma / 2) * dt * dt,
          .inertia_lead = 1 - gamma,
          .error_of_change = std::abs(beta - 1.0 / 6)};
}

struct AlphaWeights {
  double inertia, force;
};

AlphaWeights alpha_weights(double rho) {
  return {(2 * rho - 1) / (rho + 1), rho / (rho + 1)};
}

StepRule generalized_alpha(double rho, double dt) {
  const AlphaWeights alpha = alpha_weights(rho);
  const double spread = alpha.force - alpha.inertia;
  StepRule rule = newmark((1 + spread) * (1 + spread) / 4, 0.5 + spread, dt);
  rule.inertia = scaled(rule.inertia, 1 - alpha.inertia);
  rule.inertia.acceleration += alpha.inertia;
  rule.inertia_lead -= alpha.inertia;
  rule.damping = scaled(rule.damping, 1 - alpha.force);
  rule.damping.velocity += alpha.force;
  rule.stiffness = 1 - alpha.force;
  rule.strain = {rule.stiffness, 0, 0};
  rule.strain_rate = rule.damping;
  rule.load_time = 1 - alpha.force;
  return rule;
}

}  // namespace

StepRule step_rule(const StandardChoices& choices, double dt) {
  switch (choices.integrator) {
    case Integrator::newmark:
      return newmark(choices.newmark_beta, choices.newmark_gamma, dt);
    case Integrator::generalized_alpha:
      return generalized_alpha(choices.rho_infinity, dt);
    case Integrator::weighted:
      break;
  }
  return weighted(choices, dt);
}

StepRule step_rule(const Settings& settings, double dt) {
  StandardChoices choices = settings.standard;
  double carried = settings.velocity_carry_over.common;
  for (const auto& [material, own] : settings.velocity_carry_over.own) carried = std::min(carried, own);
  choices.force_weight = std::max(choices.force_weight, 1 - carried / 2);
  return step_rule(choices, dt);
}

StepRule resting_rule(double tau) {
  return {.inertia = {1 / (tau * tau), 0, 0},
          .damping = {},
          .end_velocity = {1, 1, 0},
          .end_acceleration = {},
          .judging_inertia = kJudging,
          .breaks_bonds = false};
}

double damping_of_rule(const StandardChoices& choices, double dt) {
  switch (choices.integrator) {
    case Integrator::newmark:
      return (choices.newmark_gamma - 0.5) * dt;
    case Integrator::generalized_alpha:
      return 0;
    case Integrator::weighted:
      break;
  }
  return (choices.force_weight - 0.5) * dt;
}

}  // namespace keyblock
