// Holds the limits of quantities in files, and ranges of numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace keyblock {

/// Limit of materials, loads, steps and velocities, which enter as products of two and as squares. 1e99, the infinity
/// of some old files, is below.
inline constexpr double kGreatestQuantity = 1e100;
/// Limit of coordinates, which enter with their fourth power, in second moments of area times a density.
inline constexpr double kGreatestLength = 1e50;

/// Range of a number. An open end does not belong to it.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  bool open_below = false;
  double greatest = std::numeric_limits<double>::infinity();
  bool open_above = false;

  constexpr bool has(double value) const {
    return (open_below ? value > least : value >= least) && (open_above ? value < greatest : value <= greatest);
  }
  constexpr bool is_bounded_below() const { return least > -std::numeric_limits<double>::infinity(); }
  constexpr bool is_bounded_above() const { return greatest < std::numeric_limits<double>::infinity(); }
  constexpr bool is_bounded() const { return is_bounded_below() || is_bounded_above(); }
};

}  // namespace keyblock
