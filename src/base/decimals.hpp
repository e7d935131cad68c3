// Keeps numbers that are sums or products of short decimals short: 0.3 instead of 0.30000000000000004.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <charconv>
#include <cmath>

namespace keyblock {

/// Returns the nearest number of at most 15 significant digits; all decimals of so many digits differ as doubles. Goes
/// by way of text: only that gives the double nearest to a decimal.
inline double short_decimal(double value) {
  constexpr int kDigits = 15;
  if (!std::isfinite(value)) return value;
  std::array<char, 32> text;
  const char* end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, kDigits - 1).ptr;
  double rounded = value;
  std::from_chars(text.data(), end, rounded);
  return rounded;
}

/// Returns time + dt as a short decimal, so that round-off does not add up over the steps of a run. If rounding would
/// change dt by more than a millionth, returns the plain sum.
inline double time_after(double time, double dt) {
  constexpr double kLargestChange = 1e-6;
  const double sum = time + dt;
  const double rounded = short_decimal(sum);
  return std::abs(rounded - sum) <= kLargestChange * std::abs(dt) ? rounded : sum;
}

/// Returns seconds of a clock, rounded to microseconds.
inline double to_microseconds(double seconds) {
  constexpr double kPerSecond = 1e6;
  return std::round(seconds * kPerSecond) / kPerSecond;
}

}  // namespace keyblock
