// A problem with the strength of its joints, of its rock, or of both divided by a factor.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problem/problem.hpp"

namespace keyblock::study {

enum class Reduced { joints, rock, both };

/// A word for tables: "joints", "rock", "both".
std::string name_of(Reduced what);

/// Throws std::invalid_argument for a word that is none.
Reduced reduced_of(const std::string& name);

/// The problem with c, tan φ and tensile strength of its joint materials over `factor` > 0, and the strengths of its
/// block materials reduced as `reduced` (material/reduced_strength.hpp) says.
Problem with_reduced_strength(Problem problem, Reduced what, double factor);

/// Throws InputError where there is nothing to reduce: no block material has a strength, or no joint material has any.
void require_strength(const Problem& problem, Reduced what);

/// Whether rock that is reduced flows with ψ < φ.
bool flows_below_friction(const Problem& problem, Reduced what);

}  // namespace keyblock::study
