// Draws a frame of a run as a small picture for a card: deformed bodies by material, no legend.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "result/field_frame.hpp"

namespace keyblock::report {

/// Returns an SVG document of the largest elements, at most `kCardShapes`; empty if the frame has none.
std::string frame_thumbnail(const FieldFrame& frame);

inline constexpr std::size_t kCardShapes = 2000;

}  // namespace keyblock::report
