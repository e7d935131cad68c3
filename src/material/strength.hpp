// Strength of a material at a plastic strain, and what may be wrong with what a case says of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/yield.hpp"

namespace keyblock {

/// Strength under uniaxial compression: 2 c cos φ / (1 - sin φ) (Coulomb 1776), 2 c, or the yield stress; of a cone
/// that of its matching. Never below 0.
double compressive_strength(const Strength& strength, const StrengthValues& values);

/// Plastic strain κ at which a change has come to its end in a point of this size (√area): as given, or
/// 2 G_f / (h Δf) of axial strain, Δf the fall of the compressive strength, times κ per axial plastic strain in
/// uniaxial compression, (m + 2)/3 with m = (1 + sin ψ)/(1 - sin ψ) of the initial flow. Infinity: no change.
double strain_of_change(const Strength& strength, double size);

/// Largest size of a point in which softening by fracture energy does not snap back: 2 E G_f / Δf² (Bažant & Oh 1983);
/// infinity where no energy is given. `modulus`: E by which the point unloads, the least on the way.
double largest_size(const Strength& strength, double modulus);

/// One that nothing reaches: of rock that stays elastic but keeps a plastic strain, or has cracks alone.
Strength unreachable_strength();
bool is_reachable(const Strength& strength);

/// Empty, or why no run can be made of it: "expected cohesion of strength: 0 or more, found -2".
std::string why_unusable(const Strength& strength);

/// What a user should know of a usable one: dilation above friction, tensile strength and matching that have no effect,
/// a matching that is not that of the flow, softening that depends on the mesh.
std::vector<std::string> doubts_of(const Strength& strength);

}  // namespace keyblock
