// A maximum that propagates NaN: std::max drops it or keeps it by the order of its arguments.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace keyblock {

/// The greater of two measures of error; one that is no number is the worst of all and stays.
inline double worse(double a, double b) {
  return b <= a ? a : std::isnan(a) ? a : b;
}

}  // namespace keyblock
