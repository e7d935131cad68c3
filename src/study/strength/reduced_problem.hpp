// A problem with the strength of its joints, of its rock, or of both divided by a factor.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "api/case_file.hpp"
#include "api/strength_choice.hpp"
#include "problem/problem.hpp"

namespace keyblock::study {

/// Divides c, tan φ and tensile strength of the joint materials by `factor` > 0, and reduces the strengths of the block
/// materials as `reduced` (material/reduced_strength.hpp) says. Exempt materials stay. If there are exempt regions, all
/// materials follow once more as they were, in their order, for what lies in them.
Problem with_reduced_strength(Problem problem, Reduced what, const Exempt& exempt, double factor);

/// Throws InputError if there is nothing to reduce: no block material has a strength, or no joint material has any, but
/// for exempt ones.
void require_strength(const Problem& problem, Reduced what, const Exempt& exempt);

/// Whether rock that is reduced flows with ψ < φ.
bool flows_below_friction(const Problem& problem, Reduced what, const Exempt& exempt);

}  // namespace keyblock::study
