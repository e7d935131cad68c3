// Sets up the equations of one step of one block: its increment and its motion at the end, up to the contact forces.
// Theory: docs/theory/03-time-integration.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/bodies/integrator.hpp"
#include "step/bodies/standard_body.hpp"

namespace keyblock {

/// Motion of a body at the start of a step.
struct BlockMotion {
  const Unknowns& q;
  const Unknowns& v;
  const Unknowns& a;
};

/// Equations of a step: Δq = free + inverse Gᵀ λ. Velocity and acceleration at the end are the known part plus the
/// rule's multiple of Δq.
struct StepEquations {
  UnknownBlock matrix;  ///< A
  UnknownBlock inverse;
  UnknownBlock judging;  ///< inverse with the inertia by which forces are judged, if the rule has one
  Unknowns free;         ///< increment without contact
  Unknowns known_velocity;
  Unknowns known_acceleration;
};

/// Inverse of a body, kept from step to step: it changes only with the rule.
struct KeptInverse {
  double inertia = 0;    ///< factor of the mass; 0: no inverse is kept
  double stiffness = 0;  ///< factor of the stiffness
  UnknownBlock inverse{};
};

/// Returns the equations of one body's step. `load`: force on the unknowns besides elastic, damping and contact forces.
/// `kept`: inverse of the same body.
StepEquations step_equations(const Body& body, const BlockMotion& start, const Unknowns& load, const StepRule& rule,
                             KeptInverse& kept);

}  // namespace keyblock
