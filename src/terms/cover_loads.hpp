// Adds forces on elements on covers (on area, along boundary, at points) and springs that support points.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuum.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

/// Adds ∫ Tᵀ b over all elements to f, exact if b is a polynomial of second order.
void add_cover_body_force(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system);

/// Subtracts ∫ Bᵀ s over all elements from f, s the initial stress; exact if s is a polynomial of second order.
void add_cover_initial_stress(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system);

/// Adds ∫ Tᵀ t along a part of the boundary to f, exact if t is a polynomial of third order.
void add_traction(const Continuum& continuum, const CoverBasis& basis, const Traction& traction, SparseSystem& system);

/// Returns the resultant of all forces that do not depend on the displacement: on areas, along boundaries, at points.
Resultant sum_of_loads(const Continuum& continuum, int degree);

/// Adds Tᵀ F to f.
void add_point_force(const CoverBasis& basis, const PointForce& load, SparseSystem& system);

/// Adds k Tᵀ n nᵀ T to K.
void add_point_spring(const CoverBasis& basis, const PointSpring& spring, SparseSystem& system);

}  // namespace keyblock
