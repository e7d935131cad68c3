// Computes the strength of a material at a plastic strain, and checks the values of a case.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/words/finding.hpp"
#include "problem/yield.hpp"

namespace keyblock {

/// Returns the strength under uniaxial compression: 2 c cos φ / (1 - sin φ) (Coulomb 1776), 2 c, or the yield stress;
/// for a cone that of its matching. Never below 0.
double compressive_strength(const Strength& strength, const StrengthValues& values);

/// Returns the plastic strain κ at which a change ends in a point of this size (√area), or infinity without a change.
/// It is as given, or follows from the fracture energy: 2 G_f / (h Δf) of axial strain, with Δf the fall of the
/// compressive strength. The factor is κ per axial plastic strain in uniaxial compression, (m + 2)/3, with m = (1 + sin
/// ψ)/(1 - sin ψ) of the initial flow.
double strain_of_change(const Strength& strength, double size);

/// Returns the largest size of a point in which softening by fracture energy does not snap back: 2 E G_f / Δf² (Bažant
/// & Oh 1983). Infinity without an energy. `modulus`: E by which the point unloads, the least on the path.
double largest_size(const Strength& strength, double modulus);

/// Returns a strength that no stress reaches, for rock that stays elastic but keeps a plastic strain or has cracks.
Strength unreachable_strength();
bool is_reachable(const Strength& strength);

/// Returns an empty string, or the reason why a run cannot use it: "expected cohesion of strength: 0 or more, found
/// -2".
std::string why_unusable(const Strength& strength);

/// Returns likely mistakes in a usable strength. They are dilation above friction, tensile strength or matching without
/// effect, a matching unlike that of the flow, and softening that depends on the mesh.
std::vector<Finding> doubts_of(const Strength& strength);

}  // namespace keyblock
