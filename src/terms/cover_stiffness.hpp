// Computes the stiffness of elements on covers against strain.
// Theory: docs/theory/08-manifold-method.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuum.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

/// Returns ∫ Bᵀ D B over an element, 2n × 2n. `moments`: those of its polygon in its shape's frame, to degree 2 (degree
/// - 1). Exact for any polygon; D must not couple shear with normal strains.
Eigen::MatrixXd cover_stiffness(const ElementShape& shape, const Eigen::VectorXd& moments,
                                const Eigen::Matrix3d& modulus);

void add_cover_stiffness(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system);

}  // namespace keyblock
