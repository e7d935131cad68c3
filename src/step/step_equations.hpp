// The equations of one step of one body: what its increment and the velocity at its end are, up to the contact forces.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/standard_body.hpp"

namespace keyblock {

/// A combination of increment, velocity and acceleration of a step: increment Δq + velocity v0 + acceleration a0.
struct StepSum {
  double increment = 0;
  double velocity = 0;
  double acceleration = 0;
};

/// What an integrator makes of a step of dt: the balance M (inertia) + C (damping) + K (q0 + stiffness Δq) = F + Gᵀ λ, and the
/// velocity at its end.
struct StepRule {
  StepSum inertia;
  StepSum damping;
  double stiffness = 1;
  StepSum end_velocity;
};

/// The rule of the chosen integrator. With weights θv of the velocity and θf of the elastic force (contact-notes 2):
///     M (Δq − dt v0)/(θv dt²) + C Δq/dt + K (q0 + θf Δq) = F,   v1 = (Δq/dt − (1−θv) v0)/θv.
StepRule step_rule(const StandardChoices& choices, double dt);

/// Δq = free + inverse Gᵀ λ.
struct StepEquations {
  UnknownBlock inverse;
  Unknowns free;            ///< increment without contact
  Unknowns known_velocity;  ///< the part of v1 that Δq does not change: v1 = rule.end_velocity.increment Δq + this
};

/// `load`: force on the unknowns besides elastic, damping and contact forces.
StepEquations step_equations(const Body& body, const Unknowns& q0, const Unknowns& v0, const Unknowns& load,
                             const StepRule& rule);

}  // namespace keyblock
