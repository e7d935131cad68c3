// Draws a scene, or a frame of a run, as a small picture for a table or a card: areas by material, no legend.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/blocks.hpp"
#include "problem/cover.hpp"
#include "problem/drawing.hpp"
#include "result/field_frame.hpp"

namespace keyblock::report {

/// Returns an SVG element for a page: the greatest blocks, the contact loops of a cover, or the lines of a drawing;
/// at most `kThumbnailShapes` of them. Cracks are chains of points on top.
std::string thumbnail(const Blocks& blocks, const std::vector<std::vector<Point>>& cracks = {});
std::string thumbnail(const Cover& cover, const std::vector<std::vector<Point>>& cracks = {});
std::string thumbnail(const Drawing& drawing, const std::vector<std::vector<Point>>& cracks = {});

/// Returns the greatest deformed elements of a frame, at most `kCardShapes`, twice as large; empty if there are none.
std::string thumbnail(const FieldFrame& frame);

inline constexpr std::size_t kThumbnailShapes = 400;
inline constexpr std::size_t kCardShapes = 2000;

}  // namespace keyblock::report
