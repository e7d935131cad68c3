// The integrators of Dynamics::standard: what each makes of inertia, damping, elastic force and the motion at the end
// of a step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "settings/settings.hpp"

namespace keyblock {

/// A combination of what a step knows: increment Δq + velocity v0 + acceleration a0.
struct StepSum {
  double increment = 0;
  double velocity = 0;
  double acceleration = 0;
};

/// The balance of a step of dt, and the motion at its end:
///     M (inertia + a damping) + K (q0 + strain + b strain_rate) = F(t0 + load_time dt) + Gᵀ λ
/// for a block of mass damping a and stiffness damping b; bodies on covers have K (q0 + stiffness Δq) and b against
/// Δq/dt.
struct StepRule {
  StepSum inertia;
  StepSum damping;
  double stiffness = 1;
  StepSum strain{1, 0, 0};
  StepSum strain_rate{};
  double load_time = 1;
  StepSum end_velocity;
  StepSum end_acceleration;
  /// What its sums amount to, for the ledger: Δq = dt (v0 + v1)/2 + velocity_lead Δv + acceleration_lead Δa and
  /// inertia = Δv/dt + inertia_lead Δa.
  double velocity_lead = 0;
  double acceleration_lead = 0;
  double inertia_lead = 0;
  /// Inertia, over that of the slowest strain mode of a body, with which forces are judged at least; 0: with that of
  /// the step. Without inertia a body answers to force mostly as a whole, and how far a contact force is from settled
  /// drowns in that.
  double judging_inertia = 0;
  double error_of_change = 0;        ///< local error of the position over dt² (a1 − a0)
  double error_of_acceleration = 0;  ///< and over dt² a: of first-order rules

  bool carries_acceleration() const { return inertia.acceleration != 0 || end_velocity.acceleration != 0; }
};

/// The rule of the chosen integrator; contact forces act over the whole step in each.
/// Weighted, with θv of the velocity and θf of the elastic force (the two-weight family of Shi 1988 at 1/2 and 1, the
/// trapezoidal rule at 1/2 and 1/2):
///     M (Δq − dt v0)/(θv dt²) + C Δq/dt + K (q0 + θf Δq) = F(½),   v1 = (Δq/dt − (1−θv) v0)/θv,   a1 = (v1 − v0)/dt.
/// Where the strains of blocks are damped critically, they have K (q0 + dt v1) + C v1 instead: strain modes too fast
/// for the step lose half their energy in each, where any weight of Δq would leave their rates turned over for ever
/// (det = 1/2, trace = 1/2 as ω dt → ∞). Where springs stop impacts they do not: what such a step takes from a rate it
/// may for a while make of strain, more than there was. Newmark 1959, with Δq = dt v0 + dt² ((½−β) a0 + β a1) and v1 =
/// v0 + dt ((1−γ) a0 + γ a1):
///     M a1 + C v1 + K q1 = F(1);   Shi's step is β = ½, γ = 1.
/// Generalised α of Chung & Hulbert 1993, damping high frequencies down to ρ∞: Newmark's sums, and
///     M ((1−αm) a1 + αm a0) + C ((1−αf) v1 + αf v0) + K (q0 + (1−αf) Δq) = F(1−αf),
///     αm = (2ρ∞−1)/(ρ∞+1),  αf = ρ∞/(ρ∞+1),  γ = ½ − αm + αf,  β = (1 − αm + αf)²/4.
/// Their local errors: Zienkiewicz & Xie 1991 for Newmark's sums, |β − 1/6| dt² (a1 − a0), and the same by Taylor for
/// weights.
StepRule step_rule(const StandardChoices& choices, double dt);

/// The same where only a share of the velocity is carried into a step: forces are weighed at its end by as much more, 1
/// where each step begins at rest. The mean of both ends would take such a step as far beyond the equilibrium as it
/// began before it.
StepRule step_rule(const Settings& settings, double dt);

/// From rest under loads that stay, with M/τ² for what holds a block that nothing else does; the velocity is the
/// increment and the v0 given, over unit time.
StepRule resting_rule(double tau);

/// β of the stiffness damping β K that the rule makes of its own at low frequencies.
double damping_of_rule(const StandardChoices& choices, double dt);

}  // namespace keyblock
