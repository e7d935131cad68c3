// A chart is drawn from the outside in: legend row, axes and grid, lines, then points on top.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/drawing/colours.hpp"
#include "report/drawing/plot.hpp"
#include "report/drawing/scene.hpp"

namespace keyblock::report {
namespace {

constexpr std::size_t kStretches = 1000;  // more than a picture has columns
constexpr std::size_t kMostMarkers = 40;
constexpr double kFlat = 0.5;  // of the greatest value: what varies less is drawn over 0

bool is_drawable(double value) {
  return std::abs(value) <= kGreatestDrawn;  // no NaN either
}

std::vector<Point> drawable_points(const Curve& curve) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i)
    if (is_drawable(curve.x[i]) && is_drawable(curve.y[i])) points.push_back({curve.x[i], curve.y[i]});
  return points;
}

/// Some of the points, evenly taken with the first and the last, so that markers do not run together.
std::vector<Point> thinned(const std::vector<Point>& points) {
  if (points.size() <= kMostMarkers) return points;
  std::vector<Point> some;
  for (std::size_t i = 0; i < kMostMarkers; ++i) some.push_back(points[i * (points.size() - 1) / (kMostMarkers - 1)]);
  return some;
}

/// The line as the eye sees it: of each of some thousand stretches the first, the lowest, the highest and the last
/// point.
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
  std::vector<Point> points = drawable_points(curve);
  points = curve.style == Curve::Style::points ? thinned(points) : condensed(points);
  std::ranges::transform(points, points.begin(), [&plot](Point p) { return plot(p); });
  if (curve.style == Curve::Style::line)
    page.polyline(points, {.stroke = colour, .stroke_width = 2});
  else
    for (Point p : points) page.circle(p, 3.2, {.fill = "#ffffff", .stroke = colour, .stroke_width = 1.5});
}

std::string_view colour_of(const Curve& curve, std::size_t index) {
  return line_colour(static_cast<int>(curve.colour.value_or(index) + 1));  // the first is that of frames and text
}

std::vector<LegendEntry> make_legend(const std::vector<Curve>& curves) {
  std::vector<LegendEntry> legend;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].label.empty()) continue;
    legend.push_back({.sign = curves[i].style == Curve::Style::line ? LegendEntry::Sign::line : LegendEntry::Sign::dots,
                      .colour = colour_of(curves[i], i),
                      .words = curves[i].label});
  }
  return legend;
}

void draw_curves(SvgPage& page, const Plot& plot, const std::vector<Curve>& curves, Curve::Style style) {
  for (std::size_t i = 0; i < curves.size(); ++i)
    if (curves[i].style == style) draw_curve(page, plot, curves[i], colour_of(curves[i], i));
}

Box bounds_of(const std::vector<Curve>& curves) {
  Box box;
  for (const Curve& curve : curves)
    for (Point p : drawable_points(curve)) box.include(p);
  return box;
}

double greatest(double a, double b) {
  return std::max(std::abs(a), std::abs(b));
}

std::vector<Curve> scaled(std::vector<Curve> curves, double x, double y) {
  for (Curve& curve : curves) {
    for (double& value : curve.x) value *= x;
    for (double& value : curve.y) value *= y;
  }
  return curves;
}

}  // namespace

bool has_points(const std::vector<Curve>& curves) {
  return std::ranges::any_of(curves, [](const Curve& curve) { return !drawable_points(curve).empty(); });
}

void draw_chart(SvgPage& page, Point corner, Point size, const std::vector<Curve>& given, const AxisLabels& labels) {
  Box box = bounds_of(given);
  if (box.empty()) return;
  if (box.high.y - box.low.y < kFlat * greatest(box.low.y, box.high.y)) box.include({box.low.x, 0});
  const Scaled x = readable(labels.x, greatest(box.low.x, box.high.x));
  const Scaled y = readable(labels.y, greatest(box.low.y, box.high.y));
  const std::vector<Curve> curves = scaled(given, x.factor, y.factor);
  box = {{x.factor * box.low.x, y.factor * box.low.y}, {x.factor * box.high.x, y.factor * box.high.y}};
  const std::vector<LegendEntry> legend = make_legend(curves);
  const double width = size.x - kPlotLeft - kPlotRight;
  const double top = legend_height(legend, width) + 6;
  const Plot plot{.corner = corner + Point{kPlotLeft, top},
                  .size = {width, size.y - top - kPlotBottom},
                  .x = make_axis(box.low.x, box.high.x, std::max(2, static_cast<int>(width / 90))),
                  .y = make_axis(box.low.y, box.high.y, 5)};
  draw_legend(page, corner + Point{kPlotLeft, 0}, width, legend);
  draw_axes(page, plot, x.label(labels.x.name), y.label(labels.y.name));
  draw_curves(page, plot, curves, Curve::Style::line);
  draw_curves(page, plot, curves, Curve::Style::points);
}

}  // namespace keyblock::report
