// Computes the deviator and its determinant; see stress_invariants.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/stress_invariants.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {

// The quotient uses the deviator over √J2, whose powers neither overflow nor vanish.
StressInvariants invariants_of(const Stress& stress) {
  StressInvariants found;
  found.mean = (stress.xx + stress.yy + stress.zz) / 3;
  const double x = stress.xx - found.mean, y = stress.yy - found.mean, z = stress.zz - found.mean;
  const double norm = std::hypot(std::hypot(x, y, z), std::numbers::sqrt2 * stress.xy);
  const double root = norm / std::numbers::sqrt2;  // √J2
  found.von_mises = std::numbers::sqrt3 * root;
  const double size = std::hypot(stress.xx, stress.yy, stress.zz);
  if (!(root > 1e-14 * std::max(size, std::abs(stress.xy)))) return found;  // rounding alone
  const double a = x / root, b = y / root, c = z / root, t = stress.xy / root;
  const double third = c * (a * b - t * t);
  const double sine = std::clamp(-1.5 * std::numbers::sqrt3 * third, -1.0, 1.0);
  found.lode_deg = std::asin(sine) / 3 * 180 / std::numbers::pi;
  return found;
}

}  // namespace keyblock
