// Refuses quantities so great or so small that their products and squares overflow or vanish.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "problem/limits.hpp"
#include "problem/problem.hpp"

namespace keyblock {

/// Returns an error for each quantity beyond these limits, also for values too near 0 where 0 is not allowed. Lists of
/// numbers are reported once, at the first. A geometry with an extent below 1 / kGreatestLength is an error too.
std::vector<InputError> immeasurable(const Problem& problem);

}  // namespace keyblock
