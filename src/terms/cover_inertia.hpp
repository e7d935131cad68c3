// Mass of bodies on covers: the matrix of inertia and the weight.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuum.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

/// ∫ ρ mᵀm of the monomials m of the local coordinates, from the moments of the polygon to twice the degree.
Eigen::MatrixXd monomial_mass(int degree, const Eigen::VectorXd& moments, double density);

/// ∫ ρ NᵀN over an element, n × n, the same for both components; `moments` are those of its polygon in its shape's
/// frame, to twice its degree. Exact for any polygon.
Eigen::MatrixXd cover_mass(const ElementShape& shape, const Eigen::VectorXd& moments, double density);

/// Whether an element is so small in its triangle that a function may be, too: then its products are the round-off of
/// moments about the middle of the triangle, and no longer positive. Summed over points they are.
bool is_small_piece(const Manifold& manifold, int element);

/// A += M: ½ vᵀ M v is the kinetic energy at any configuration, for x = X + Σ N_a d_a is linear in d.
void add_cover_mass(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system);

/// ∫ ρ Tᵀ g, of all functions; `acceleration` g with y up.
Eigen::VectorXd cover_weight(const Continuum& continuum, const CoverBasis& basis, Point acceleration);

}  // namespace keyblock
