// Draws a pair of axes on a page, for charts of curves and of single runs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/drawing/svg.hpp"
#include "report/drawing/ticks.hpp"

namespace keyblock::report {

inline constexpr double kPlotLeft = 74;    // tick labels and the turned label of the y axis
inline constexpr double kPlotRight = 16;   // half of the last tick label
inline constexpr double kPlotBottom = 44;  // tick labels and the label of the x axis

/// The plot inside its axes.
struct Plot {
  Point corner;
  Point size;
  Axis x;
  Axis y;

  Point operator()(Point p) const {
    return {corner.x + size.x * (p.x - x.low()) / (x.high() - x.low()),
            corner.y + size.y * (y.high() - p.y) / (y.high() - y.low())};
  }
};

/// Draws grid, frame, ticks and labels of the axes.
void draw_axes(SvgPage& page, const Plot& plot, const std::string& x_label, const std::string& y_label);

}  // namespace keyblock::report
