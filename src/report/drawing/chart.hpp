// Draws curves over a pair of axes with round ticks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/drawing/readable.hpp"
#include "report/drawing/svg.hpp"

namespace keyblock::report {

/// One curve. `x` and `y` are of equal length; pairs that are not finite, or beyond `kGreatestDrawn`, are left out.
struct Curve {
  enum class Style { line, points };
  std::string label;  ///< empty: not in the legend
  std::vector<double> x;
  std::vector<double> y;
  Style style = Style::line;
  std::optional<std::size_t> colour = {};  ///< that of the curve with this index; if absent, its own
};

/// Words of the axes.
struct AxisLabels {
  Described x;
  Described y;
};

/// Returns true if there is anything to draw.
bool has_points(const std::vector<Curve>& curves);

/// Draws axes, grid, curves and, above them, their labels into the rectangle of the page, in units that keep numbers
/// short. The y axis has zero on it if values vary by less than half of the greatest, so that little looks little.
void draw_chart(SvgPage& page, Point corner, Point size, const std::vector<Curve>& curves, const AxisLabels& labels);

}  // namespace keyblock::report
