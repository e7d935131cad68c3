// Quantities so great or so small that their products and squares are no numbers any more, refused before anything is
// made of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "problem/problem.hpp"

namespace keyblock {

/// Materials, loads, steps and velocities enter as products of two and as squares. 1e99, the infinity of some old
/// files, is below.
inline constexpr double kGreatestQuantity = 1e100;
/// Coordinates enter with their fourth power, in second moments of area times a density.
inline constexpr double kGreatestLength = 1e50;

/// What of a problem is beyond these limits, in either direction where 0 is no value, each list of numbers at its
/// first; and a geometry whose extent is below 1 / kGreatestLength.
std::vector<InputError> immeasurable(const Problem& problem);

}  // namespace keyblock
