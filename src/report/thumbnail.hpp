// Draws a scene as a small picture for a table: areas by material, no legend.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/blocks.hpp"
#include "problem/cover.hpp"
#include "problem/drawing.hpp"

namespace keyblock::report {

/// Returns an SVG element for a page: the greatest blocks, the contact loops of a cover, or the lines of a drawing;
/// at most `kThumbnailShapes` of them. Cracks are chains of points on top.
std::string thumbnail(const Blocks& blocks, const std::vector<std::vector<Point>>& cracks = {});
std::string thumbnail(const Cover& cover, const std::vector<std::vector<Point>>& cracks = {});
std::string thumbnail(const Drawing& drawing, const std::vector<std::vector<Point>>& cracks = {});

inline constexpr std::size_t kThumbnailShapes = 400;

}  // namespace keyblock::report
