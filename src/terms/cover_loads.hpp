// Forces on elements on covers: on their area, along their boundary, at points; and springs that hold points.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuum.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

/// f += ∫ Tᵀ b over all elements, exact where b is a polynomial of second order.
void add_cover_body_force(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system);

/// f -= ∫ Bᵀ s over all elements, s the initial stress, exact where it is a polynomial of second order.
void add_cover_initial_stress(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system);

/// f += ∫ Tᵀ t along a part of the boundary, exact where t is a polynomial of third order.
void add_traction(const Continuum& continuum, const CoverBasis& basis, const Traction& traction, SparseSystem& system);

/// All forces that do not depend on the displacement: on areas, along boundaries, at points; each as above.
Resultant sum_of_loads(const Continuum& continuum, int degree);

/// f += Tᵀ F.
void add_point_force(const CoverBasis& basis, const PointForce& load, SparseSystem& system);

/// K += k Tᵀ n nᵀ T.
void add_point_spring(const CoverBasis& basis, const PointSpring& spring, SparseSystem& system);

}  // namespace keyblock
