// Prescribes displacements of a boundary that no mesh follows, by Nitsche's method.
// Theory: docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuum.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

/// Adds a(u, v) - ∫ σ(u)n·Pv - ∫ σ(v)n·P(u - g) + β ∫ P(u - g)·v with β = c (degree)² M/h (Nitsche 1971).
///
/// P selects the fixed component, σ includes the initial stress, M is the modulus against strain in one direction. h is
/// the size of the element's triangle, c that of `stabilisation`. The method is consistent and symmetric, and adds no
/// unknown. For elastoplastic or cracked rock, whose stress has no formula, and for elements with near-tip functions
/// the terms of σ(u) are left out; β is then that of HeldEdges.
void add_prescribed(const Continuum& continuum, const CoverBasis& basis, const PrescribedDisplacement& prescribed,
                    SparseSystem& system);

/// Returns the force of the support on the body, ∫ Pσn - βP(u - g), from the solution `unknowns`. With it, forces on
/// each body and their moments balance to round-off.
Resultant reaction_of(const Continuum& continuum, const CoverBasis& basis, const PrescribedDisplacement& prescribed,
                      const Eigen::VectorXd& unknowns);

}  // namespace keyblock
