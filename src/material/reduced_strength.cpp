// Scales angles by their tangents; see reduced_strength.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/reduced_strength.hpp"

#include <algorithm>
#include <cmath>

#include "problem/units/unit_conversion.hpp"

namespace keyblock {
namespace {

double angle_over(double degrees, double factor) {
  return std::atan(std::tan(degrees * kDegree) / factor) / kDegree;
}

StrengthValues reduced(StrengthValues values, double factor) {
  const double friction = angle_over(values.friction_deg, factor);
  values.dilation_deg = values.dilation_deg < values.friction_deg ? std::min(values.dilation_deg, friction)
                                                                  : angle_over(values.dilation_deg, factor);
  values.friction_deg = friction;
  values.cohesion /= factor;
  values.yield_stress /= factor;
  if (values.tensile_strength) *values.tensile_strength /= factor;
  return values;
}

}  // namespace

Strength reduced(const Strength& strength, double factor) {
  if (factor == 1) return strength;
  Strength weaker = strength;
  weaker.values = reduced(strength.values, factor);
  if (weaker.change) weaker.change->values = reduced(strength.change->values, factor);
  return weaker;
}

bool flows_below_friction(const Strength& strength) {
  const auto is_below = [](const StrengthValues& values) { return values.dilation_deg < values.friction_deg; };
  return is_below(strength.values) || (strength.change && is_below(strength.change->values));
}

}  // namespace keyblock
