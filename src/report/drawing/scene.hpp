// What the pictures of blocks have in common: marks of points, the width of block edges, legend and scale bar.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "problem/run_choices.hpp"
#include "report/drawing/svg.hpp"

namespace keyblock::report {

inline constexpr std::string_view kBoltColour = "#7a0177";

enum class Mark { fixed_point, loading_point, measured_point };

/// Draws the sign of a point of the scene at a place of the page.
void draw_mark(SvgPage& page, Point at, Mark mark);

/// Draws a bolt between two places of the page.
void draw_bolt(SvgPage& page, Point from, Point to);

/// Width of block edges: one page unit for few blocks, finer where they crowd.
double edge_width(Point page_size, std::size_t block_count);

/// One entry of a legend: a filled square, a line, or the sign of a point.
struct LegendEntry {
  enum class Sign { area, line, dashed_line, dots, mark };
  Sign sign = Sign::area;
  std::string_view colour;
  Mark mark = Mark::fixed_point;
  std::string words;
};

/// Height that the entries take when set in rows of `width`.
double legend_height(const std::vector<LegendEntry>& entries, double width);
void draw_legend(SvgPage& page, Point corner, double width, const std::vector<LegendEntry>& entries);

/// A bar of round length, at most a quarter of `width`, with its length in the unit of the case. Its left end is at
/// `left`.
void draw_scale_bar(SvgPage& page, Point left, double width, const PageMap& map, const Units& units);

}  // namespace keyblock::report
