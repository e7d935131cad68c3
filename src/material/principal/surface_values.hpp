// Defines the values of a yield surface at a plastic strain, with or without their derivatives.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <type_traits>
#include <unsupported/Eigen/AutoDiff>

#include "material/principal/surface_of_kappa.hpp"
#include "problem/units/unit_conversion.hpp"

namespace keyblock::principal {

/// Number with its derivatives by the three trial stresses and κ.
using Dual = Eigen::AutoDiffScalar<Eigen::Vector4d>;
template <class T>
using PrincipalValues = std::array<T, 3>;

inline double value_of(double x) {
  return x;
}
inline double value_of(const Dual& x) {
  return x.value();
}

/// Returns κ over the strain of the change, at most 1, as a T.
template <class T>
T share_of_change(const SurfaceOfKappa& surface, double kappa) {
  T share(kappa >= surface.strain ? 1.0 : kappa / surface.strain);
  if constexpr (std::is_same_v<T, Dual>)
    share.derivatives() = Eigen::Vector4d(0, 0, 0, kappa >= surface.strain ? 0.0 : 1 / surface.strain);
  return share;
}

/// Values of a surface at κ; angles in radians.
template <class T>
struct ValuesAt {
  T cohesion, friction, dilation, yield_stress, tension;
  bool limited = false;  ///< in tension

  ValuesAt(const SurfaceOfKappa& surface, double kappa) {
    const StrengthValues& from = surface.strength.values;
    const StrengthValues& to = surface.strength.change ? surface.strength.change->values : from;
    const T share = share_of_change<T>(surface, kappa);
    const auto at = [&](double a, double b) { return T(a + share * (b - a)); };
    cohesion = at(from.cohesion, to.cohesion);
    friction = at(from.friction_deg * kDegree, to.friction_deg * kDegree);
    dilation = at(from.dilation_deg * kDegree, to.dilation_deg * kDegree);
    yield_stress = at(from.yield_stress, to.yield_stress);
    limited = from.tensile_strength.has_value();
    tension = at(from.tensile_strength.value_or(0), to.tensile_strength.value_or(0));
  }
};

}  // namespace keyblock::principal
