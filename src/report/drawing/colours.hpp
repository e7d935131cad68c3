// Colours of materials, curves and values, from page/src/draw/palette.json. Colour-blind readers can distinguish them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "report/drawing/palette.hpp"

namespace keyblock::report {

using Channels = std::array<double, 3>;  ///< red, green, blue, 0 to 255

inline Channels channels_of(std::string_view colour) {
  Channels channels{};
  for (std::size_t i = 0; i < channels.size(); ++i) {
    int value = 0;
    const char* digits = colour.data() + 1 + 2 * i;
    std::from_chars(digits, digits + 2, value, 16);
    channels.at(i) = value;
  }
  return channels;
}

/// Returns the colour at a share of a map, from 0 to 1, in steps of 1/200: an image of few colours has a palette.
inline Channels colour_at(std::span<const std::string_view> map, double share) {
  constexpr double kSteps = 200;
  const double at = std::round(std::clamp(share, 0.0, 1.0) * kSteps) / kSteps * static_cast<double>(map.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), map.size() - 2);
  const Channels low = channels_of(map[below]), high = channels_of(map[below + 1]);
  const auto mix = [&](std::size_t i) { return std::lerp(low.at(i), high.at(i), at - static_cast<double>(below)); };
  return {mix(0), mix(1), mix(2)};
}

inline std::string hex(const Channels& colour) {
  const auto part = [&](std::size_t i) { return static_cast<int>(std::lround(colour.at(i))); };
  return fmt::format("#{:02x}{:02x}{:02x}", part(0), part(1), part(2));
}

constexpr std::string_view kHeldColour = "#b4b4b4";  ///< of blocks with a fixed point
constexpr std::string_view kCompressionColour = palette::kAboutZero.front();
constexpr std::string_view kTensionColour = palette::kAboutZero.back();

constexpr std::string_view area_colour(int material) {
  return palette::kAreas.at(static_cast<std::size_t>(material < 0 ? 0 : material) % palette::kAreas.size());
}
constexpr std::string_view line_colour(int material) {
  return palette::kLines.at(static_cast<std::size_t>(material < 0 ? 0 : material) % palette::kLines.size());
}

}  // namespace keyblock::report
