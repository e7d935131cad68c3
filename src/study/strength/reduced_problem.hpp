// Divides the strength of joints, of rock, or of both by a factor.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "api/case_file.hpp"
#include "api/strength_choice.hpp"
#include "problem/problem.hpp"

namespace keyblock::study {

/// Divides c, tan φ and tensile strength of the joint materials by `factor` > 0. Strengths of block materials are
/// reduced by `reduced` (material/reduced_strength.hpp). Exempt materials stay. If there are exempt regions, unreduced
/// copies of all materials follow in their order, for elements inside them.
Problem with_reduced_strength(Problem problem, Reduced what, const Exempt& exempt, double factor);

/// Throws InputError if there is nothing to reduce: except for exempt ones, no block material or no joint material has
/// a strength.
void require_strength(const Problem& problem, Reduced what, const Exempt& exempt);

/// Returns true if reduced rock flows with ψ < φ.
bool flows_below_friction(const Problem& problem, Reduced what, const Exempt& exempt);

}  // namespace keyblock::study
