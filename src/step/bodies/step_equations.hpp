// The equations of one step of one body: what its increment and its motion at the end are, up to the contact forces.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/bodies/integrator.hpp"
#include "step/bodies/standard_body.hpp"

namespace keyblock {

/// A body at the start of a step.
struct BlockMotion {
  const Unknowns& q;
  const Unknowns& v;
  const Unknowns& a;
};

/// Δq = free + inverse Gᵀ λ. Velocity and acceleration at the end are the known part and the rule's share of Δq.
struct StepEquations {
  UnknownBlock matrix;  ///< A
  UnknownBlock inverse;
  UnknownBlock judging;  ///< the same with the inertia by which forces are judged, of a rule that has one
  Unknowns free;         ///< increment without contact
  Unknowns known_velocity;
  Unknowns known_acceleration;
};

/// The inverse of a body, from step to step: it changes with the rule alone.
struct KeptInverse {
  double inertia = 0;    ///< factor of the mass; 0: none is kept
  double stiffness = 0;  ///< factor of the stiffness
  UnknownBlock inverse{};
};

/// `load`: force on the unknowns besides elastic, damping and contact forces. `kept`: of this body.
StepEquations step_equations(const Body& body, const BlockMotion& start, const Unknowns& load, const StepRule& rule,
                             KeptInverse& kept);

}  // namespace keyblock
