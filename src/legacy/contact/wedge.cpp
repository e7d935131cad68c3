// Computes directions of edges and tests two wedges for overlap (legacy-rules 3).
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/contact/wedge.hpp"

#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

bool reaches_into(double direction, double low, double high) {
  return (low < direction && direction < high) || (low < direction + 360 && direction + 360 < high);
}

}  // namespace

double one_turn(double degrees) {
  if (degrees < 0) return degrees + 360;
  return degrees > 360 ? degrees - 360 : degrees;
}

double edge_direction(Point edge, double offset) {
  double degrees = std::atan(edge.y / (std::abs(edge.x) + offset)) * (180 / std::numbers::pi);
  if (edge.x < 0) degrees = 180 - degrees;
  return degrees < 0 ? degrees + 360 : degrees;
}

bool may_touch(const Wedge& a, const Wedge& b, double overlap) {
  const bool a_is_big = a.angle() > b.angle();
  const Wedge& big = a_is_big ? a : b;
  const Wedge& small = a_is_big ? b : a;
  const double low = big.from + overlap;
  const double high = big.from + big.angle() - overlap;
  return !reaches_into(small.from, low, high) && !reaches_into(small.to, low, high) &&
         !reaches_into(small.from + small.angle() / 2, low, high);
}

}  // namespace keyblock
