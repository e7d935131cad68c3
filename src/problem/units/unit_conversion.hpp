// Units with which values are written: what a unit is in the base units that a case declares.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "problem/run_choices.hpp"

namespace keyblock {

/// Powers of mass, length and time. An angle has none.
struct Dimension {
  int mass = 0;
  int length = 0;
  int time = 0;

  bool operator==(const Dimension&) const = default;
};

inline constexpr Dimension kLengthDimension{0, 1, 0};
inline constexpr Dimension kTimeDimension{0, 0, 1};
inline constexpr Dimension kAcceleration{0, 1, -2};
inline constexpr Dimension kStress{1, -1, -2};
inline constexpr Dimension kDensity{1, -3, 0};
inline constexpr Dimension kForcePerVolume{1, -2, -2};
inline constexpr Dimension kForcePerLength{1, 0, -2};  ///< a force per unit of thickness

/// A unit in SI: its dimension, and how many kg, m and s it is; of an angle, how many degrees.
struct Unit {
  Dimension dimension;
  double factor = 1;
  bool is_angle = false;
};

/// "GPa", "kN/m3", "m/s^2", "MN/m/m", "deg"; nothing where it is none. Factors: SI brochure (BIPM 2019), 9th edition,
/// and for inch, foot, yard and pound the international yard and pound agreement of 1959.
std::optional<Unit> unit_named(std::string_view name);

/// The number and the unit of "20 GPa"; nothing where the text is no such value.
struct Quantity {
  double number = 0;
  std::string unit;
};
std::optional<Quantity> quantity_in(std::string_view text);

/// How many SI units the base units of a case make of a quantity of this dimension; nothing where the case does not
/// declare a unit that it takes.
std::optional<double> si_factor(const Units& units, const Dimension& dimension);

/// "stress, such as 20 GPa": what a value of this dimension may be written as.
std::string example_of(const Dimension& dimension);

}  // namespace keyblock
