// Checks a problem, corrects what the old programs correct, and collects all its errors at once.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "problem/problem.hpp"

namespace keyblock {

/// Validated problem: warnings name inputs that were corrected, errors inputs that could not be.
struct Checked {
  Problem problem;
  Warnings warnings;
  std::vector<InputError> errors;
};

/// Validates a problem. It brings material numbers into their range (as Shi's analysis programs do, but with a
/// warning), gives bolts their properties, and accelerates blocks by a ground motion. It reports likely mistakes and
/// errors: one warning per kind and number, at its first place.
Checked check(Problem problem);

/// Returns true if the geometry has no fixed point or line, and the case no other support.
bool fixes_nothing(const Problem& problem);

/// Returns true if no weight, load, stress or pretension acts, and no stage can change that.
bool is_unloaded(const Problem& problem);

}  // namespace keyblock
