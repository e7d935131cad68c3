// Lists names of units that a case may declare and that results use; unit_conversion.cpp holds their sizes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

namespace keyblock {

inline constexpr std::array<std::string_view, 8> kLengthUnits{"m", "mm", "cm", "dm", "km", "in", "ft", "yd"};
inline constexpr std::array<std::string_view, 8> kMassUnits{"kg", "g", "t", "Mg", "kt", "lb", "slug", "tonne"};
inline constexpr std::array<std::string_view, 7> kTimeUnits{"s", "ms", "min", "h", "d", "day", "year"};
/// Units of force, to declare instead of one of mass. The first that equals the force made of the declared units names
/// it.
inline constexpr std::array<std::string_view, 10> kForceUnits{"N",  "kN",  "MN",  "GN",  "mN",
                                                              "µN", "lbf", "kip", "kgf", "tf"};
inline constexpr std::array<std::string_view, 10> kStressUnits{"Pa",  "kPa", "MPa", "GPa", "mPa",
                                                               "µPa", "psi", "ksi", "psf", "bar"};

}  // namespace keyblock
