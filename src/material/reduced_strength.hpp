// Scales the strength of rock, for strength reduction.
// Theory: docs/theory/11-strength-reduction.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "problem/yield.hpp"

namespace keyblock {

/// Divides c, tan φ, tensile strength and yield stress by `factor` > 0, including those after a change (Zienkiewicz,
/// Humpheson & Lewis 1975). tan ψ is divided too if flow is associated, ψ = φ, or above that. If ψ < φ it stays, but
/// never above the reduced φ. Plastic strain and fracture energy of a change stay. The factor 1 changes no bit.
Strength reduced(const Strength& strength, double factor);

/// Returns true if ψ < φ initially or after a change. No limit theorem then bounds the load, and the solver may lose
/// equilibrium before the rock does (Davis 1968; Griffiths & Lane 1999).
bool flows_below_friction(const Strength& strength);

}  // namespace keyblock
