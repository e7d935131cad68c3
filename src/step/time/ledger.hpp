// The energy and momentum of one step of Dynamics::standard, term by term.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "result/ledger.hpp"
#include "step/scene/step_constraints.hpp"
#include "step/time/smooth_solve.hpp"

namespace keyblock {

/// Energy that moving supports gave by impulses, beside the work that their forces did in the smooth motion.
struct SupportWork {
  double clean_up = 0;
  double jump = 0;
};

/// What an accepted step leaves behind for the books; it refers to what the step holds.
struct StepTrail {
  const Motion& start;
  const UnknownsTable& loads;          ///< on the unknowns, weight included
  const Touches& touches;              ///< of the smooth motion
  const StepConstraints& constraints;  ///< whose forces follow those of the touches
  const SmoothMotion& smooth;
  const UnknownsTable& cleaned;  ///< velocities after the clean-up
  const Motion& end;             ///< after projection and jump
  double dt = 0;
  const StepRule& rule;
  SupportWork given = {};
};

/// What one step adds to the sums of the ledger.
struct StepAccount {
  EnergyFlow flow;
  Momentum impulse;

  StepAccount& operator+=(const StepAccount& other);
};

/// Closes to round-off because Δqᵀ times the balance of the step (`StepRule`), M inertia + C damping + K (q0 + κ Δq) =
/// F + Gᵀ λ, is
///     ΔT + ΔU + A + (κ−½) Δqᵀ K Δq + Δqᵀ C damping = F·Δq + λᵀ G Δq,
///     A = pᵀ M Δv/dt + (dt v̄ + p)ᵀ M r,   Δq = dt v̄ + p,   inertia = Δv/dt + r,   v̄ = (v0 + v1)/2,
/// with p and r by the rule from the changes of velocity and acceleration: for the weights θv and θf the algorithmic
/// loss is (θv−½) Δvᵀ M Δv + (θf−½) Δqᵀ K Δq.
/// A contact of compliance c (0 for multipliers) whose spring has the force s at the ends of the step, and λ in it, has
/// over the gap or slip y that λ works on
///     −λ Δy = Δ(c s²/2) + c (λ − s̄) Δs − λ (Δy + c Δs),  s̄ the mean of both ends:
/// stored, algorithmic, and what is left: closing of a gap, or friction. A point that stuck before and sticks still has
/// no friction: its law asks for no velocity at the end of the step, and what slips meanwhile is creep.
StepAccount account_of(const StandardScene& scene, const StepTrail& trail);

StoredEnergy stored_energy(const StandardScene& scene, const Motion& motion);

double kinetic_energy(const StandardScene& scene, const UnknownsTable& v);

/// Step, time and flows are left at zero.
LedgerRow ledger_row(const StandardScene& scene, const Motion& motion);

LedgerScope ledger_scope(const StandardScene& scene);

}  // namespace keyblock
