// A problem with the strength of its joints, of its rock, or of both divided by a factor.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problem/problem.hpp"
#include "study/strength/exempt.hpp"

namespace keyblock::study {

enum class Reduced { joints, rock, both };

/// A word for tables: "joints", "rock", "both".
std::string name_of(Reduced what);

/// Throws std::invalid_argument for a word that is none.
Reduced reduced_of(const std::string& name);

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
