// Assembles the elastic stiffness of each element.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/terms/term.hpp"

namespace keyblock {

/// Returns S Bᵀ D B of an element with current area S, n × n.
UnknownBlock stiffness_matrix(const Basis& basis, double area, const BlockMaterial& material, const Settings& settings);

/// Adds K += S Bᵀ D B with the current area S (Shi 1988, elastic submatrix). Quirk plane_strain_factor: Berkeley plane
/// strain is stiffer by (1+nu)/(1-nu) (legacy-rules 7.2).
void add_elastic(const StepContext& context, System& system);

}  // namespace keyblock
