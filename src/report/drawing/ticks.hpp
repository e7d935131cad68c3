// Chooses round values for axes and scale bars, 1, 2 or 5 times a power of ten, and writes them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace keyblock::report {

/// Returns the largest of 1, 2, 5 times a power of ten that does not exceed `value` (> 0).
double round_down(double value);

/// An axis that covers the data and ends on ticks.
struct Axis {
  std::vector<double> ticks;        ///< ascending, at least two
  std::vector<std::string> labels;  ///< of the ticks, in units of 10^exponent
  int exponent = 0;                 ///< a multiple of three, 0 unless the labels would be long

  double low() const { return ticks.front(); }
  double high() const { return ticks.back(); }
};

/// Returns "displacement [L]  × 1e-3"; for exponent 0 only the label.
std::string with_exponent(const std::string& label, int exponent);

/// Greater values have no place on an axis: its span would overflow.
inline constexpr double kGreatestDrawn = 1e300;

/// Returns about `wanted` intervals from at or below `low` to at or above `high`, both cut to `kGreatestDrawn`.
Axis make_axis(double low, double high, int wanted);

/// Does the same for an axis of powers of ten, for values > 0. Ticks are logarithms, at decades, or at 1, 2 and 5 of
/// each if there are fewer than three; labels are the values.
Axis make_log_axis(double low, double high);

}  // namespace keyblock::report
