// Where a tip goes on, and how near it is to doing so: three criteria on its stress intensity factors.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/near_tip_field.hpp"
#include "problem/cover_plan.hpp"

namespace keyblock {

struct Kink {
  double angle = 0;       ///< rad, from straight ahead to the left
  double equivalent = 0;  ///< K_eq, F/L^1.5: a tip of mode I alone with this factor is as near to going on; 0: closed
};

/// hoop_stress: greatest σθθ (Erdogan & Sih 1963), K_eq = cos²(θ/2) (K_I cos(θ/2) - 3 K_II sin(θ/2)). strain_energy:
/// least density of strain energy r w (Sih 1974) of the minima that have hoop tension, K_eq² = 8 π μ S / (κ - 1).
/// energy_release: greatest energy release rate of a short kink, by the expansion of Amestoy & Leblond (1992) to the
/// twentieth order of the angle, K_eq = √(K1*² + K2*²). A closed tip has K_I = 0 here: a negative one is
/// taken for 0, and goes nowhere where K_II is no more than the noise of K_I.
Kink kink(GrowthCriterion criterion, const PlaneElasticity& rock, const StressIntensity& k);

/// K_eq where the rock has a toughness of mode II: K_Ic √((K_I/K_Ic)² + (K_II/K_IIc)²), K_I below 0 taken for 0
/// (mixed-mode envelope, Wu 1967); else that of the criterion.
double equivalent_of(const Kink& by_criterion, const Toughness& toughness, const StressIntensity& k);

/// Factors behind a short kink of the angle (rad), by the same expansion; within 80 degrees.
StressIntensity behind_kink(const StressIntensity& k, double angle);

}  // namespace keyblock
