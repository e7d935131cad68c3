// Stiffness of elements on covers against strain.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuum.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

/// ∫ Bᵀ D B over an element, 2n × 2n; `moments` are those of its polygon in its shape's frame, to degree 2 (degree -
/// 1). Exact for any polygon; D has no coupling of shear with normal strains.
Eigen::MatrixXd cover_stiffness(const ElementShape& shape, const Eigen::VectorXd& moments,
                                const Eigen::Matrix3d& modulus);

void add_cover_stiffness(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system);

}  // namespace keyblock
