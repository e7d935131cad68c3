// Numbers as engineers write coordinates and lengths: 12470, not 1.247e+04.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace keyblock {

inline constexpr double kLeastPlain = 1e-4;
inline constexpr double kMostPlain = 1e10;

/// So many significant digits, but all of those before the decimal point, without zeros at the end; with a power of ten
/// below 1e-4 and from 1e10 on. As %g where that writes none.
inline std::string plain(double value, int digits = 4) {
  const double size = std::abs(value);
  if (!(size >= kLeastPlain && size < kMostPlain)) return fmt::format("{:.{}g}", value, digits);
  const int decimals = std::max(0, digits - 1 - static_cast<int>(std::floor(std::log10(size))));
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (decimals > 0) text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace keyblock
