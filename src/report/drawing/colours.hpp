// Defines colours of materials and curves that colour-blind readers can distinguish (after Okabe and Ito).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace keyblock::report {

constexpr std::array<std::string_view, 8> kAreaColours{"#e3d9c6", "#b9d7ea", "#f6cfa0", "#b8ddc4",
                                                       "#e9c3d6", "#f1ebae", "#c9c9dd", "#d9b9a5"};
constexpr std::array<std::string_view, 8> kLineColours{"#333333", "#d55e00", "#0072b2", "#009e73",
                                                       "#cc79a7", "#e69f00", "#56b4e9", "#8a6d3b"};

constexpr std::string_view kHeldColour = "#b4b4b4";  ///< of blocks with a fixed point

constexpr std::string_view area_colour(int material) {
  return kAreaColours.at(static_cast<std::size_t>(material < 0 ? 0 : material) % kAreaColours.size());
}
constexpr std::string_view line_colour(int material) {
  return kLineColours.at(static_cast<std::size_t>(material < 0 ? 0 : material) % kLineColours.size());
}

}  // namespace keyblock::report
