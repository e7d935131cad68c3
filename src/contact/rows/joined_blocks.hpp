// Elastic blocks that springs join and nothing lets go: one linear system, whatever moves far in it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/rows/contact_row.hpp"

namespace keyblock {

/// Displacements x of blocks of stiffness A under loads f, with a spring along every row of G, of compliance c > 0
/// (length / force) and longer by g than at rest: (A + Gᵀ C⁻¹ G) x = f − Gᵀ C⁻¹ g, C = diag(c). Rows 2i and 2i + 1 act
/// on the same two elements; A is positive definite. The forces of the springs are −(G x + g) / c. Nothing where
/// round-off leaves no factor. Bodies on covers have no part in it.
std::optional<UnknownsTable> displacements_of_joined(const Table<ElementIndex, UnknownBlock>& stiffness,
                                                     const ContactRows& rows, const Eigen::VectorXd& compliance,
                                                     const Eigen::VectorXd& gaps, const UnknownsTable& loads);

}  // namespace keyblock
