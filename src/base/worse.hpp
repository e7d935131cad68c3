// Returns the larger of two errors; NaN always wins. (`std::max` keeps or drops NaN depending on argument order.)
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace keyblock {

/// Returns the greater of two measures of error, or NaN if either is NaN.
inline double worse(double a, double b) {
  return b <= a ? a : std::isnan(a) ? a : b;
}

}  // namespace keyblock
