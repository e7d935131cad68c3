// Refuses quantities so great or so small that their products and squares overflow or vanish.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "problem/problem.hpp"

namespace keyblock {

/// Limit of materials, loads, steps and velocities, which enter as products of two and as squares. 1e99, the infinity
/// of some old files, is below.
inline constexpr double kGreatestQuantity = 1e100;
/// Limit of coordinates, which enter with their fourth power, in second moments of area times a density.
inline constexpr double kGreatestLength = 1e50;

/// Returns an error for each quantity beyond these limits, also for values too near 0 where 0 is not allowed. Lists of
/// numbers are reported once, at the first. A geometry with an extent below 1 / kGreatestLength is an error too.
std::vector<InputError> immeasurable(const Problem& problem);

}  // namespace keyblock
