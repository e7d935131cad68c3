// Defines cones in principal stresses (von Mises, Drucker–Prager, a limit of the mean stress) and the return to them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "material/principal/surface_values.hpp"

namespace keyblock::principal {

template <class T>
struct ConeAt {
  T slope, flow, strength, tension;
  bool limited = false;

  ConeAt(const SurfaceOfKappa& surface, double kappa) {
    const ValuesAt<T> v(surface, kappa);
    limited = v.limited;
    tension = v.tension;
    slope = flow = T(0.0);
    if (surface.strength.surface == YieldSurface::von_mises) {
      strength = T(v.yield_stress / std::numbers::sqrt3);
      return;
    }
    T unused;
    matched(surface.strength.matching, v.cohesion, v.friction, slope, strength);
    matched(surface.strength.matching, v.cohesion, v.dilation, flow, unused);
    limited = limited && (!(value_of(slope) > 0) || value_of(tension) < value_of(apex()));
  }

  T apex() const { return T(strength / (3.0 * slope)); }

  static void matched(ConeMatching matching, const T& cohesion, const T& angle, T& slope, T& strength) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const T sine = sin(angle), cosine = cos(angle);
    if (matching == ConeMatching::plane_strain) {
      const T root = T(sqrt(T(9.0 * cosine * cosine + 12.0 * sine * sine)));
      slope = T(sine / root);
      strength = T(3.0 * cohesion * cosine / root);
      return;
    }
    const double sign = matching == ConeMatching::compression ? -1 : 1;
    const T below = T(std::numbers::sqrt3 * (3.0 + sign * sine));
    slope = T(2.0 * sine / below);
    strength = T(6.0 * cohesion * cosine / below);
  }
};

template <class T>
T mean_of(const PrincipalValues<T>& s) {
  return T((s[0] + s[1] + s[2]) / 3.0);
}

/// Returns √J2.
template <class T>
T shear_of(const PrincipalValues<T>& s) {
  using std::sqrt;
  const T a = T(s[0] - s[1]), b = T(s[1] - s[2]), c = T(s[2] - s[0]);
  return T(sqrt(T((a * a + b * b + c * c) / 6.0)));
}

enum class ConePart { cone, apex, limit, rim };

/// Returns the deviator, without the mean that rounding of a great mean leaves in it.
template <class T>
PrincipalValues<T> deviator_of(const PrincipalValues<T>& s) {
  const T mean = mean_of(s);
  const PrincipalValues<T> d = {T(s[0] - mean), T(s[1] - mean), T(s[2] - mean)};
  const T rest = mean_of(d);
  return {T(d[0] - rest), T(d[1] - rest), T(d[2] - rest)};
}

/// Returns the stress of this deviator's direction with the given √J2 and mean.
template <class T>
PrincipalValues<T> with_shear(const PrincipalValues<T>& trial, const T& shear, const T& mean) {
  const T ratio = T(shear / shear_of(trial));
  PrincipalValues<T> s = deviator_of(trial);
  for (T& value : s) value = T(value * ratio + mean);
  return s;
}

template <class T>
PrincipalValues<T> land(ConePart part, const PrincipalValues<T>& trial, const ConeAt<T>& cone, double bulk,
                        double shear_modulus) {
  switch (part) {
    case ConePart::apex:
      return {cone.apex(), cone.apex(), cone.apex()};
    case ConePart::limit: {
      const PrincipalValues<T> d = deviator_of(trial);
      return {T(d[0] + cone.tension), T(d[1] + cone.tension), T(d[2] + cone.tension)};
    }
    case ConePart::rim:
      return with_shear(trial, T(cone.strength - 3.0 * cone.slope * cone.tension), cone.tension);
    case ConePart::cone:
      break;
  }
  const T mean = mean_of(trial);
  const T x = T((shear_of(trial) + 3.0 * cone.slope * mean - cone.strength) /
                (shear_modulus + 9.0 * bulk * cone.slope * cone.flow));
  const T lower = T(mean - 3.0 * bulk * cone.flow * x);
  return with_shear(trial, T(cone.strength - 3.0 * cone.slope * lower), lower);
}

inline ConePart part_of(const PrincipalValues<double>& trial, const ConeAt<double>& cone, double bulk,
                        double shear_modulus) {
  const double shear = shear_of(trial);
  const double mean = mean_of(trial);
  const double beyond = shear + 3 * cone.slope * mean - cone.strength;
  ConePart part = ConePart::cone;
  double lower = mean;
  if (beyond > 0) {
    const double x = beyond / (shear_modulus + 9 * bulk * cone.slope * cone.flow);
    lower = mean - 3 * bulk * cone.flow * x;
    if (cone.slope > 0 && !(shear - shear_modulus * x > 0)) {
      part = ConePart::apex;
      lower = cone.apex();
    }
  }
  if (!cone.limited || lower <= cone.tension) return part;
  return shear > cone.strength - 3 * cone.slope * cone.tension ? ConePart::rim : ConePart::limit;
}

}  // namespace keyblock::principal
