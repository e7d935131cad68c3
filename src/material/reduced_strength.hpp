// Rock made weaker or stronger all at once, as strength reduction asks for.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/yield.hpp"

namespace keyblock {

/// c, tan φ, tensile strength and yield stress over `factor` > 0, those after a change too (Zienkiewicz, Humpheson &
/// Lewis 1975). tan ψ is divided likewise where flow is associated, ψ = φ, or above that; where ψ < φ it stays, and is
/// never above the reduced φ. Plastic strain and fracture energy of a change stay. Under the factor 1 nothing changes,
/// to the bit.
Strength reduced(const Strength& strength, double factor);

/// Whether ψ < φ at the start or after a change: then no limit theorem bounds the load, and equilibrium may be lost by
/// the solver before it is by the rock (Davis 1968; Griffiths & Lane 1999).
bool flows_below_friction(const Strength& strength);

}  // namespace keyblock
