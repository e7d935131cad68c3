// Holds the limits of quantities in files.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace keyblock {

/// Limit of materials, loads, steps and velocities, which enter as products of two and as squares. 1e99, the infinity
/// of some old files, is below.
inline constexpr double kGreatestQuantity = 1e100;
/// Limit of coordinates, which enter with their fourth power, in second moments of area times a density.
inline constexpr double kGreatestLength = 1e50;

}  // namespace keyblock
