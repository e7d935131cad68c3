// Prescribed displacement of a boundary that no mesh follows, by Nitsche's method.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuum.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

/// a(u, v) - ∫ σ(u)n·Pv - ∫ σ(v)n·P(u - g) + β ∫ P(u - g)·v with β = c (degree)² M/h (Nitsche 1971): P leaves the held
/// component, σ includes the initial stress, M is the modulus against strain in one direction, h the size of the
/// element's triangle, c that of `stabilisation`. Consistent and symmetric; no unknown is added. Of rock that may yield
/// or has cracks, whose stress no formula knows, and of elements with near-tip functions the terms of σ(u) are left out
/// and β is that of HeldEdges.
void add_prescribed(const Continuum& continuum, const CoverBasis& basis, const PrescribedDisplacement& prescribed,
                    SparseSystem& system);

/// What the support exerts on the body, ∫ Pσn - βP(u - g), from the solution `unknowns`: with it the forces on each
/// body and their moments balance to round-off.
Resultant reaction_of(const Continuum& continuum, const CoverBasis& basis, const PrescribedDisplacement& prescribed,
                      const Eigen::VectorXd& unknowns);

}  // namespace keyblock
