// Converts units of written values to the base units that a case declares.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include "problem/run_choices.hpp"

namespace keyblock {

/// Powers of mass, length and time, halves too (stress intensity). An angle has none.
struct Dimension {
  double mass = 0;
  double length = 0;
  double time = 0;

  bool operator==(const Dimension&) const = default;
};

inline constexpr Dimension kLengthDimension{0, 1, 0};
inline constexpr Dimension kTimeDimension{0, 0, 1};
inline constexpr Dimension kForceDimension{1, 1, -2};
inline constexpr Dimension kVelocity{0, 1, -1};
inline constexpr Dimension kRate{0, 0, -1};
inline constexpr Dimension kAcceleration{0, 1, -2};
inline constexpr Dimension kStress{1, -1, -2};
inline constexpr Dimension kDensity{1, -3, 0};
inline constexpr Dimension kForcePerVolume{1, -2, -2};
inline constexpr Dimension kForcePerLength{1, 0, -2};  ///< force per unit of thickness
inline constexpr Dimension kToughness{1, -0.5, -2};    ///< stress times the root of a length

inline constexpr double kDegree = std::numbers::pi / 180;  ///< rad
/// Round-off of products of factors: units that differ by less are the same.
inline constexpr double kSameUnit = 1e-12;

/// Unit in SI: its dimension, and its size in kg, m and s; for an angle, in degrees.
struct Unit {
  Dimension dimension;
  double factor = 1;
  bool is_angle = false;
};

/// Returns the unit of a name, or nothing if it is no unit. Names are "GPa", "kN/m3", "m/s^2", "MN/m/m", "N·mm",
/// "MPa√m", "kN/m^1.5", "1/s", "deg", "rad/s". An angle alone is in degrees; in a product it is a number, in radians.
/// Factors: SI brochure (BIPM 2019), 9th edition; for inch, foot, yard and pound the international yard and pound
/// agreement of 1959.
std::optional<Unit> unit_named(std::string_view name);

/// Number and unit of a text such as "20 GPa". `quantity_in` returns nothing if the text is no such value.
struct Quantity {
  double number = 0;
  std::string unit;
};
std::optional<Quantity> quantity_in(std::string_view text);

/// Returns the number of SI units in a unit of this dimension made of the base units of a case. Returns nothing if the
/// case does not declare a unit needed.
std::optional<double> si_factor(const Units& units, const Dimension& dimension);

/// Returns the unit of mass of a case that declares one of force, or of stress: force times time² over length, stress
/// times length times time². It is a name if there is one ("t" for kN, m and s), else a product ("lbf·s²/in"). Empty if
/// it cannot be made.
std::string mass_of_force(const std::string& force, const std::string& length, const std::string& time);
std::string mass_of_stress(const std::string& stress, const std::string& length, const std::string& time);

}  // namespace keyblock
