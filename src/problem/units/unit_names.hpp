// Names of units that a case may declare and that results are given in; how much each is stands in
// unit_conversion.cpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

namespace keyblock {

inline constexpr std::array<std::string_view, 8> kLengthUnits{"m", "mm", "cm", "dm", "km", "in", "ft", "yd"};
inline constexpr std::array<std::string_view, 8> kMassUnits{"kg", "g", "t", "Mg", "kt", "lb", "slug", "tonne"};
inline constexpr std::array<std::string_view, 7> kTimeUnits{"s", "ms", "min", "h", "d", "day", "year"};
/// In place of one of mass. The first that is as large as what the declared units make gives a force its name.
inline constexpr std::array<std::string_view, 10> kForceUnits{"N",  "kN",  "MN",  "GN",  "mN",
                                                              "µN", "lbf", "kip", "kgf", "tf"};
inline constexpr std::array<std::string_view, 10> kStressUnits{"Pa",  "kPa", "MPa", "GPa", "mPa",
                                                               "µPa", "psi", "ksi", "psf", "bar"};

}  // namespace keyblock
