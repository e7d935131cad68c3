// Defines colours of materials and curves that colour-blind readers can distinguish (after Okabe and Ito).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace keyblock::report {

constexpr std::array<std::string_view, 8> kAreaColours{"#e3d9c6", "#b9d7ea", "#f6cfa0", "#b8ddc4",
                                                       "#e9c3d6", "#f1ebae", "#c9c9dd", "#d9b9a5"};
constexpr std::array<std::string_view, 8> kLineColours{"#333333", "#d55e00", "#0072b2", "#009e73",
                                                       "#cc79a7", "#e69f00", "#56b4e9", "#8a6d3b"};

using Channels = std::array<double, 3>;  ///< red, green, blue, 0 to 255

/// Returns a colour from dark blue at 0 to pale yellow at 1; its lightness alone tells the order.
inline Channels heat_colour(double share) {
  constexpr std::array<Channels, 5> kStops{
      {{38, 40, 110}, {40, 104, 142}, {52, 160, 130}, {152, 205, 96}, {250, 236, 150}}};
  const double place = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
  Channels mixed{};
  for (std::size_t channel = 0; channel < mixed.size(); ++channel)
    mixed[channel] = std::lerp(kStops[below][channel], kStops[below + 1][channel], place - static_cast<double>(below));
  return mixed;
}

constexpr std::string_view kHeldColour = "#b4b4b4";  ///< of blocks with a fixed point

constexpr std::string_view area_colour(int material) {
  return kAreaColours.at(static_cast<std::size_t>(material < 0 ? 0 : material) % kAreaColours.size());
}
constexpr std::string_view line_colour(int material) {
  return kLineColours.at(static_cast<std::size_t>(material < 0 ? 0 : material) % kLineColours.size());
}

}  // namespace keyblock::report
