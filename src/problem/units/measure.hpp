// What numbers of files and results measure, and what their unit is called where a case declares its units.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "problem/units/unit_conversion.hpp"

namespace keyblock {

/// What a number measures. Masses, forces and energies of a scene are those of a slice one unit of length thick: kN/m
/// where force is in kN.
struct Measure {
  Dimension dimension;          ///< of the whole, without the thickness
  bool of_slice = false;        ///< per unit thickness
  std::string_view angle = {};  ///< "deg" or "rad" of an angle

  bool operator==(const Measure&) const = default;
};

namespace measures {
inline constexpr Measure kNumber{};  ///< a ratio, a count, a name
inline constexpr Measure kDegrees{{}, false, "deg"};
inline constexpr Measure kRadians{{}, false, "rad"};
inline constexpr Measure kLength{kLengthDimension};
inline constexpr Measure kArea{{0, 2, 0}};
inline constexpr Measure kTime{kTimeDimension};
inline constexpr Measure kVelocity{keyblock::kVelocity};
inline constexpr Measure kAcceleration{keyblock::kAcceleration};
inline constexpr Measure kRotationRate{kRate, false, "rad"};
inline constexpr Measure kRate{keyblock::kRate};
inline constexpr Measure kStress{keyblock::kStress};
inline constexpr Measure kDensity{keyblock::kDensity};
inline constexpr Measure kForcePerVolume{keyblock::kForcePerVolume};
inline constexpr Measure kToughness{keyblock::kToughness};
inline constexpr Measure kEnergyPerArea{kForcePerLength};
inline constexpr Measure kMass{{1, 0, 0}, true};
inline constexpr Measure kMomentOfInertia{{1, 2, 0}, true};
inline constexpr Measure kForce{{1, 1, -2}, true};
inline constexpr Measure kMoment{{1, 2, -2}, true};
inline constexpr Measure kEnergy{{1, 2, -2}, true};
inline constexpr Measure kStiffness{{1, 0, -2}, true};
inline constexpr Measure kMomentum{{1, 1, -1}, true};
inline constexpr Measure kAngularMomentum{{1, 2, -1}, true};
}  // namespace measures

/// Of the number itself: that of the whole over a length where it is of a slice.
Dimension dimension_of(const Measure& measure);

/// "kN/m", "MPa", "t·m²/m", "rad/s": in the units of the case, as `unit_named` reads them. Where the case does not
/// declare what that takes, by letters per unit thickness: "F", "F/L²", "M L²". Empty for a plain number.
std::string unit_of(const Measure& measure, const Units& units);

/// Whether `unit_of` has a name other than letters.
bool is_declared(const Measure& measure, const Units& units);

/// "gap [mm]"; of a plain number the name alone.
std::string with_unit(std::string_view name, const Measure& measure, const Units& units);

/// The same, but without letters where the case does not declare what it takes.
std::string with_declared(std::string_view name, const Measure& measure, const Units& units);

/// "20 GPa", and "a stress, such as "20 GPa"": how such a value may be written.
std::string_view example_value(const Measure& measure);
std::string example_of(const Measure& measure);

/// In the units of the case, "20 GPa" that should be of this kind; nothing where it is another, or no value with a
/// unit. Throws nothing; where the case declares too little, `lacks_units` says so.
struct Converted {
  std::optional<double> number;
  bool lacks_units = false;
};
Converted converted(std::string_view text, const Measure& measure, const Units& units);

}  // namespace keyblock
