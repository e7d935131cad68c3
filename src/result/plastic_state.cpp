// Rotates plastic strain into the axes of the plane, and sums areas; see plastic_state.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/plastic_state.hpp"

#include <cmath>

namespace keyblock {

bool has_yielded(const YieldState& memory) {
  return memory.plastic.cwiseAbs().maxCoeff() > 0;
}

PlasticState plastic_state(const YieldState& memory, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double xx = memory.plastic(0), yy = memory.plastic(1), xy = memory.plastic(2) / 2;
  return {c * c * xx + s * s * yy - 2 * c * s * xy,
          s * s * xx + c * c * yy + 2 * c * s * xy,
          c * s * (xx - yy) + (c * c - s * s) * xy,
          memory.plastic(3),
          memory.kappa,
          memory.region,
          has_yielded(memory)};
}

void PlasticTotals::add(double of, const YieldState& memory) {
  area += of;
  if (has_yielded(memory)) yielded += of;
  if (memory.region != YieldRegion::elastic) yielding += of;
}

}  // namespace keyblock
