// Units of force and stress that a case may declare in place of one of mass.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

namespace keyblock::formats {

inline constexpr std::array<std::string_view, 7> kForceUnits{"N", "kN", "MN", "kgf", "tf", "lbf", "kip"};
inline constexpr std::array<std::string_view, 7> kStressUnits{"Pa", "kPa", "MPa", "GPa", "psi", "ksi", "psf"};

}  // namespace keyblock::formats
