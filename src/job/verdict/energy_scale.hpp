// Computes the least energy that a scene is compared with: blocks at rest store almost none.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "result/frame.hpp"
#include "run/prepare.hpp"

namespace keyblock {

// Fraction of the size of the mean block. Blocks at rest store only the strain energy of their weight, which decreases
// with their stiffness. A fraction of it does not measure their motion. Energies are therefore compared with at least
// the work of all weights over this displacement.
inline constexpr double kWayOfWeight = 1e-4;

/// Returns the work of the weight of all free elements of `first` over `kWayOfWeight` of the size of the mean block,
/// per unit thickness [energy].
double work_of_weight(const Prepared& prepared, const Frame& first);

/// Returns the greater of that work and the energy of the initial stress of all free elements (σ·D⁻¹σ/2 in the plane,
/// over their areas): stress that relaxes at the start is stored no longer.
double least_energy(const Prepared& prepared, const Frame& first);

}  // namespace keyblock
