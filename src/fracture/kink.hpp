// Finds the direction in which a tip propagates and its K_eq, by one of three criteria on its stress intensity factors.
// Theory: docs/theory/10-fracture.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/near_tip_field.hpp"
#include "problem/cover_plan.hpp"

namespace keyblock {

struct Kink {
  double angle = 0;       ///< rad, from straight ahead to the left
  double equivalent = 0;  ///< K_eq, F/L^1.5: a pure mode I tip with this factor is as near to propagation; 0: closed
};

/// Returns the kink by a criterion. hoop_stress: greatest σθθ (Erdogan & Sih 1963), K_eq = cos²(θ/2) (K_I cos(θ/2) - 3
/// K_II sin(θ/2)). strain_energy: least density of strain energy r w (Sih 1974) of the minima that have hoop tension,
/// K_eq² = 8 π μ S / (κ - 1). energy_release: greatest energy release rate of a short kink, K_eq = √(K1*² + K2*²), by
/// the expansion of Amestoy & Leblond (1992) to the twentieth order of the angle. A closed tip has K_I = 0 here: a
/// negative K_I counts as 0. It does not propagate if K_II is within the noise of K_I.
Kink kink(GrowthCriterion criterion, const PlaneElasticity& rock, const StressIntensity& k);

/// Returns K_eq of rock with a mode II toughness: K_Ic √((K_I/K_Ic)² + (K_II/K_IIc)²), negative K_I counting as 0
/// (mixed-mode envelope, Wu 1967). Without that toughness it returns K_eq of the criterion.
double equivalent_of(const Kink& by_criterion, const Toughness& toughness, const StressIntensity& k);

/// Returns the factors behind a short kink of the angle [rad], by the same expansion; within 80 degrees.
StressIntensity behind_kink(const StressIntensity& k, double angle);

}  // namespace keyblock
