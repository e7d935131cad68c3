// Grid first, frame and labels on top.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/plot.hpp"

namespace keyblock::report {

void draw_axes(SvgPage& page, const Plot& plot, const std::string& x_label, const std::string& y_label) {
  const Style grid{.stroke = "#dddddd", .stroke_width = 0.8};
  const double bottom = plot.corner.y + plot.size.y;
  for (std::size_t i = 0; i < plot.x.ticks.size(); ++i) {
    const double x = plot({plot.x.ticks[i], plot.y.low()}).x;
    page.line({x, plot.corner.y}, {x, bottom}, grid);
    page.text({x, bottom + 16}, plot.x.labels[i], {.size = 12, .anchor = Anchor::middle});
  }
  for (std::size_t i = 0; i < plot.y.ticks.size(); ++i) {
    const double y = plot({plot.x.low(), plot.y.ticks[i]}).y;
    page.line({plot.corner.x, y}, {plot.corner.x + plot.size.x, y}, grid);
    page.text({plot.corner.x - 6, y + 4}, plot.y.labels[i], {.size = 12, .anchor = Anchor::end});
  }
  page.rectangle(plot.corner, plot.size.x, plot.size.y, {.stroke = "#222222", .stroke_width = 1});
  page.text({plot.corner.x + plot.size.x / 2, bottom + 36}, with_exponent(x_label, plot.x.exponent),
            {.size = 13, .anchor = Anchor::middle});
  page.text({plot.corner.x - kPlotLeft + 16, plot.corner.y + plot.size.y / 2}, with_exponent(y_label, plot.y.exponent),
            {.size = 13, .anchor = Anchor::middle, .turn_deg = -90});
}

}  // namespace keyblock::report
