// Computes the mass matrix of NMM bodies.
// Theory: docs/theory/02-equations-of-motion.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuum.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

/// Returns ∫ ρ mᵀm of the monomials m of the local coordinates, from the moments of the polygon to twice the degree.
Eigen::MatrixXd monomial_mass(int degree, const Eigen::VectorXd& moments, double density);

/// Returns ∫ ρ NᵀN over an element, n × n, the same for both components. `moments`: those of its polygon in its shape's
/// frame, to twice its degree. Exact for any polygon.
Eigen::MatrixXd cover_mass(const ElementShape& shape, const Eigen::VectorXd& moments, double density);

/// Returns true if an element is so small in its triangle that a function may be small too. Products from moments about
/// the middle of the triangle are then round-off, and not positive; sums over points are.
bool is_small_piece(const Manifold& manifold, int element);

/// Adds M to A. ½ vᵀ M v is the kinetic energy in every configuration, because x = X + Σ N_a d_a is linear in d.
void add_cover_mass(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system);

}  // namespace keyblock
