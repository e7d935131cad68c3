// A chart is drawn from the outside in: legend row, axes and grid, lines, then points on top.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/colours.hpp"
#include "report/scene.hpp"
#include "report/ticks.hpp"

namespace keyblock::report {
namespace {

constexpr std::size_t kStretches = 1000;  // more than a picture has columns
constexpr double kLeft = 74;              // tick labels and the turned label of the y axis
constexpr double kRight = 16;             // half of the last tick label
constexpr double kBottom = 44;            // tick labels and the label of the x axis
constexpr std::size_t kMostMarkers = 40;

std::vector<Point> finite_points(const Curve& curve) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i)
    if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i])) points.push_back({curve.x[i], curve.y[i]});
  return points;
}

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

std::string with_exponent(const std::string& label, int exponent) {
  return exponent == 0 ? label : fmt::format("{}  × 1e{}", label, exponent);
}

void draw_axes(SvgPage& page, const Plot& plot, const AxisLabels& labels) {
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
  page.text({plot.corner.x + plot.size.x / 2, bottom + 36}, with_exponent(labels.x, plot.x.exponent),
            {.size = 13, .anchor = Anchor::middle});
  page.text({plot.corner.x - kLeft + 16, plot.corner.y + plot.size.y / 2}, with_exponent(labels.y, plot.y.exponent),
            {.size = 13, .anchor = Anchor::middle, .turn_deg = -90});
}

/// Some of the points, evenly taken with the first and the last, so that markers do not run together.
std::vector<Point> thinned(const std::vector<Point>& points) {
  if (points.size() <= kMostMarkers) return points;
  std::vector<Point> some;
  for (std::size_t i = 0; i < kMostMarkers; ++i) some.push_back(points[i * (points.size() - 1) / (kMostMarkers - 1)]);
  return some;
}

/// The line as the eye sees it: of each of some thousand stretches the first, the lowest, the highest and the last point.
std::vector<Point> condensed(const std::vector<Point>& points) {
  if (points.size() <= 4 * kStretches) return points;
  std::vector<Point> line;
  for (std::size_t i = 0; i < kStretches; ++i) {
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(i * points.size() / kStretches);
    const auto last = points.begin() + static_cast<std::ptrdiff_t>((i + 1) * points.size() / kStretches) - 1;
    auto [low, high] = std::minmax_element(first, last + 1, [](Point a, Point b) { return a.y < b.y; });
    if (high < low) std::swap(low, high);
    for (const auto& point : {first, low, high, last}) line.push_back(*point);
  }
  return line;
}

void draw_curve(SvgPage& page, const Plot& plot, const Curve& curve, std::string_view colour) {
  std::vector<Point> points = finite_points(curve);
  points = curve.style == Curve::Style::points ? thinned(points) : condensed(points);
  std::ranges::transform(points, points.begin(), [&plot](Point p) { return plot(p); });
  if (curve.style == Curve::Style::line)
    page.polyline(points, {.stroke = colour, .stroke_width = 2});
  else
    for (Point p : points) page.circle(p, 3.2, {.fill = "#ffffff", .stroke = colour, .stroke_width = 1.5});
}

int curve_colour(std::size_t index) {
  return static_cast<int>(index + 1);  // the first line colour is that of frames and text
}

std::vector<LegendEntry> make_legend(const std::vector<Curve>& curves) {
  std::vector<LegendEntry> legend;
  for (std::size_t i = 0; i < curves.size(); ++i)
    legend.push_back({.sign = curves[i].style == Curve::Style::line ? LegendEntry::Sign::line : LegendEntry::Sign::dots,
                      .colour = line_colour(curve_colour(i)),
                      .words = curves[i].label});
  return legend;
}

void draw_curves(SvgPage& page, const Plot& plot, const std::vector<Curve>& curves, Curve::Style style) {
  for (std::size_t i = 0; i < curves.size(); ++i)
    if (curves[i].style == style) draw_curve(page, plot, curves[i], line_colour(curve_colour(i)));
}

}  // namespace

bool has_points(const std::vector<Curve>& curves) {
  return std::ranges::any_of(curves, [](const Curve& curve) { return !finite_points(curve).empty(); });
}

void draw_chart(SvgPage& page, Point corner, Point size, const std::vector<Curve>& curves, const AxisLabels& labels) {
  Box box;
  for (const Curve& curve : curves)
    for (Point p : finite_points(curve)) box.include(p);
  if (box.empty()) return;
  const std::vector<LegendEntry> legend = make_legend(curves);
  const double width = size.x - kLeft - kRight;
  const double top = legend_height(legend, width) + 6;
  const Plot plot{.corner = corner + Point{kLeft, top},
                  .size = {width, size.y - top - kBottom},
                  .x = make_axis(box.low.x, box.high.x, std::max(2, static_cast<int>(width / 90))),
                  .y = make_axis(box.low.y, box.high.y, 5)};
  draw_legend(page, corner + Point{kLeft, 0}, width, legend);
  draw_axes(page, plot, labels);
  draw_curves(page, plot, curves, Curve::Style::line);
  draw_curves(page, plot, curves, Curve::Style::points);
}

}  // namespace keyblock::report
