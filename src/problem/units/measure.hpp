// Describes the quantity that a number in files and results measures, and names its unit in the units of a case.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "problem/units/unit_conversion.hpp"

namespace keyblock {

/// Quantity of a number. Masses, forces and energies of a scene are those of a slice one unit of length thick: kN/m if
/// force is in kN.
struct Measure {
  Dimension dimension;          ///< of the whole, without the thickness
  bool of_slice = false;        ///< per unit thickness
  std::string_view angle = {};  ///< "deg" or "rad" for an angle

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

/// Returns the dimension of the number itself: that of the whole over a length, if it is of a slice.
Dimension dimension_of(const Measure& measure);

/// Returns "kN/m", "MPa", "t·m²/m", "rad/s": in the units of the case, as `unit_named` reads them. If the case does not
/// declare the units needed, it returns letters per unit thickness: "F", "F/L²", "M L²". Empty for a plain number.
std::string unit_of(const Measure& measure, const Units& units);

/// Returns true if `unit_of` has a name other than letters.
bool is_declared(const Measure& measure, const Units& units);

/// Returns "gap [mm]"; for a plain number only the name.
std::string with_unit(std::string_view name, const Measure& measure, const Units& units);

/// Returns the same, but without letters if the case does not declare the units needed.
std::string with_declared(std::string_view name, const Measure& measure, const Units& units);

/// Returns "20 GPa", and "a stress, such as "20 GPa"": the form in which such a value may be written.
std::string_view example_value(const Measure& measure);
std::string example_of(const Measure& measure);

/// Value of "20 GPa" in the units of the case, if it is of this kind. Empty if it is of another kind, or no value with
/// a unit. Throws nothing; if the case declares too few units, `lacks_units` is true.
struct Converted {
  std::optional<double> number;
  bool lacks_units = false;
};
Converted converted(std::string_view text, const Measure& measure, const Units& units);

}  // namespace keyblock
