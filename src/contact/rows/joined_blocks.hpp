// Solves elastic blocks joined by permanent springs in one linear system.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/rows/contact_row.hpp"

namespace keyblock {

/// Returns displacements x of blocks of stiffness A under loads f. Every row of G has a spring of compliance c > 0
/// (length / force), which is longer by g than unstressed:
///     (A + Gᵀ C⁻¹ G) x = f − Gᵀ C⁻¹ g,   C = diag(c).
/// Rows 2i and 2i + 1 act on the same two elements; A is positive definite. The forces of the springs are −(G x + g) /
/// c. The result is empty if round-off prevents a factorisation. NMM bodies take no part.
std::optional<UnknownsTable> displacements_of_joined(const Table<ElementIndex, UnknownBlock>& stiffness,
                                                     const ContactRows& rows, const Eigen::VectorXd& compliance,
                                                     const Eigen::VectorXd& gaps, const UnknownsTable& loads);

}  // namespace keyblock
