// Defines the integrators of Dynamics::standard: their combinations for inertia, damping, elastic force and the motion
// at the end of a step. Theory: docs/theory/03-time-integration.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "settings/settings.hpp"

namespace keyblock {

/// Linear combination of the data of a step: increment Δq + velocity v0 + acceleration a0.
struct StepSum {
  double increment = 0;
  double velocity = 0;
  double acceleration = 0;
};

/// Balance of a step of dt, and the motion at its end:
///   M (inertia + a damping) + K (q0 + strain + b strain_rate) = F(t0 + load_time dt) + Gᵀ λ
/// for a block of mass damping a and stiffness damping b. NMM bodies have K (q0 + stiffness Δq), and b against Δq/dt.
struct StepRule {
  StepSum inertia;
  StepSum damping;
  double stiffness = 1;
  StepSum strain{1, 0, 0};
  StepSum strain_rate{};
  double load_time = 1;
  StepSum end_velocity;
  StepSum end_acceleration;
  /// Coefficients for the energy balance: Δq = dt (v0 + v1)/2 + velocity_lead Δv + acceleration_lead Δa and inertia =
  /// Δv/dt + inertia_lead Δa.
  double velocity_lead = 0;
  double acceleration_lead = 0;
  double inertia_lead = 0;
  /// Least inertia with which forces are judged, relative to that of the slowest strain mode of a body; 0: the inertia
  /// of the step. Without inertia a body answers a force mostly by rigid motion, which hides how far contact forces are
  /// from converged.
  double judging_inertia = 0;
  /// False: bonds beyond their strength hold and are named. Pseudo steps pass through states that rock never takes.
  bool breaks_bonds = true;
  double error_of_change = 0;        ///< local error of the position over dt² (a1 − a0)
  double error_of_acceleration = 0;  ///< the same over dt² a, for first-order rules

  bool carries_acceleration() const { return inertia.acceleration != 0 || end_velocity.acceleration != 0; }
};

/// Returns the rule of the chosen integrator. Contact forces act over the whole step in each. Weighted: θv weighs the
/// velocity, θf the elastic force. The two-weight family of Shi 1988 has 1/2 and 1, the trapezoidal rule 1/2 and 1/2.
///   M (Δq − dt v0)/(θv dt²) + C Δq/dt + K (q0 + θf Δq) = F(½),   v1 = (Δq/dt − (1−θv) v0)/θv,   a1 = (v1 − v0)/dt.
/// If the strains of blocks are damped critically, the force is K (q0 + dt v1) + C v1 instead. Strain modes too fast
/// for the step then lose half their energy per step (det = 1/2, trace = 1/2 as ω dt → ∞). Any weight of Δq would
/// reverse their rates for ever. If springs stop impacts, the force stays K (q0 + θf Δq) + C Δq/dt. Otherwise strain
/// could for a while gain more energy than the rate lost. Newmark 1959 has Δq = dt v0 + dt² ((½−β) a0 + β a1) and v1 =
/// v0 + dt ((1−γ) a0 + γ a1).
///   M a1 + C v1 + K q1 = F(1);   Shi's step is β = ½, γ = 1.
/// Generalised α of Chung & Hulbert 1993 damps high frequencies down to ρ∞. It has Newmark's sums, and
///   M ((1−αm) a1 + αm a0) + C ((1−αf) v1 + αf v0) + K (q0 + (1−αf) Δq) = F(1−αf),
///   αm = (2ρ∞−1)/(ρ∞+1),  αf = ρ∞/(ρ∞+1),  γ = ½ − αm + αf,  β = (1 − αm + αf)²/4.
/// Local errors: Zienkiewicz & Xie 1991 for Newmark's sums, |β − 1/6| dt² (a1 − a0); the same by Taylor series for
/// weights.
StepRule step_rule(const StandardChoices& choices, double dt);

/// Returns the rule for settings that carry only a fraction of the velocity into each step. The weight of forces at the
/// end is then at least 1 less half that fraction, which is 1 if each step begins without velocity. The mean of both
/// ends would overshoot the equilibrium by as much as the step began short of it.
StepRule step_rule(const Settings& settings, double dt);

/// Returns the rule of a step without initial velocity under constant loads. M/τ² holds blocks that nothing else holds.
/// The velocity is the increment plus the given v0, over unit time.
StepRule resting_rule(double tau);

/// Returns β of the stiffness damping β K that the rule itself causes at low frequencies.
double damping_of_rule(const StandardChoices& choices, double dt);

}  // namespace keyblock
