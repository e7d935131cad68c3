// Computes the remainder of forces that should balance.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/force_balance.hpp"

#include <algorithm>

namespace keyblock {

double ForceBalance::unbalanced() const {
  Resultant sum = loads;
  double largest = length(loads.force);
  sum.add(springs);
  for (const Resultant& support : supports) {
    sum.add(support);
    largest = std::max(largest, length(support.force));
  }
  return largest > 0 ? length(sum.force) / largest : length(sum.force);
}

}  // namespace keyblock
