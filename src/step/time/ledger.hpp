// Computes the energy and momentum of one step of Dynamics::standard, term by term. Theory:
// docs/theory/12-energy-balance.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "result/ledger.hpp"
#include "step/scene/step_constraints.hpp"
#include "step/time/smooth_motion.hpp"

namespace keyblock {

/// Energy that moving supports give by impulses, in addition to the work of their forces in the smooth motion.
struct SupportWork {
  double clean_up = 0;
  double jump = 0;
};

/// Input of the energy balance from one accepted step. Holds references into that step.
struct StepTrail {
  const Motion& start;
  const UnknownsTable& loads;          ///< on the unknowns, weight included
  const Touches& touches;              ///< of the smooth motion
  const StepConstraints& constraints;  ///< whose forces follow those of the contacts
  const SmoothMotion& smooth;
  const UnknownsTable& cleaned;  ///< velocities after the clean-up
  const Motion& end;             ///< after projection and jump
  double dt = 0;
  const StepRule& rule;
  SupportWork given = {};
};

/// Contribution of one step to the sums of the energy balance.
struct StepAccount {
  EnergyFlow flow;
  Momentum impulse;

  StepAccount& operator+=(const StepAccount& other);
};

/// Returns the energy terms of a step. They close to round-off. Δqᵀ times the balance of the step (`StepRule`), with M
/// inertia + C damping + K (q0 + κ Δq) = F + Gᵀ λ, is
///     ΔT + ΔU + A + (κ−½) Δqᵀ K Δq + Δqᵀ C damping = F·Δq + λᵀ G Δq,
///     A = pᵀ M Δv/dt + (dt v̄ + p)ᵀ M r,   Δq = dt v̄ + p,   inertia = Δv/dt + r,   v̄ = (v0 + v1)/2.
/// The rule gives p and r from the changes of velocity and acceleration. For the weights θv and θf the algorithmic loss
/// is (θv−½) Δvᵀ M Δv + (θf−½) Δqᵀ K Δq. A contact has the compliance c (0 for multipliers). Its spring has the force s
/// at the ends of the step and λ during it. Over the gap or slip y on which λ works
///     −λ Δy = Δ(c s²/2) + c (λ − s̄) Δs − λ (Δy + c Δs),  s̄ the mean of both ends.
/// The three terms are stored energy, algorithmic loss, and closing of a gap or friction. A point that stuck before and
/// still sticks has no friction. Its law requires zero velocity at the end of the step, and slip during it is creep.
StepAccount account_of(const StandardScene& scene, const StepTrail& trail);

StoredEnergy stored_energy(const StandardScene& scene, const Motion& motion);

double kinetic_energy(const StandardScene& scene, const UnknownsTable& v);

/// Returns the row of stored energy and momentum; step, time and flows are zero.
LedgerRow ledger_row(const StandardScene& scene, const Motion& motion);

LedgerScope ledger_scope(const StandardScene& scene);

}  // namespace keyblock
