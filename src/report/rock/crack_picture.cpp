// Paths by crack and end; see crack_picture.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/rock/crack_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "problem/units/measure.hpp"
#include "report/drawing/chart.hpp"
#include "report/drawing/scene.hpp"
#include "report/page.hpp"

namespace keyblock::report {
namespace {

constexpr double kTop = 40;
constexpr double kCaption = 24;
constexpr double kSceneHeight = 420;
constexpr double kChartHeight = 260;
constexpr double kGap = 24;
constexpr std::string_view kRock = "#e8e4da";
constexpr std::string_view kOutline = "#666666";
constexpr std::string_view kPath = "#c0392b";
constexpr std::string_view kShear = "#7d3c98";
constexpr std::string_view kEdge = "#999080";
constexpr std::size_t kMostCurves = 4;  // tips of which curves are drawn: more cannot be told apart

struct Path {
  std::vector<Point> points;
  std::vector<double> length, mode_1, mode_2, factor;
};

/// Returns the path of each end of each crack.
std::map<std::pair<int, bool>, Path> paths_of(const History& history) {
  std::map<std::pair<int, bool>, Path> paths;
  for (const HistoryRow& row : history.rows)
    for (const TipState& tip : row.tips) {
      Path& path = paths[{tip.crack, tip.at_end}];
      path.points.push_back(tip.at);
      if (!tip.has_room) continue;
      path.length.push_back(tip.length);
      path.mode_1.push_back(tip.mode_1);
      path.mode_2.push_back(tip.mode_2);
      path.factor.push_back(row.load_factor);
    }
  return paths;
}

void draw_bodies(SvgPage& page, const PageMap& map, const Frame& start) {
  page.layer([&] {
    for (const ElementFrame& element : start.elements)
      page.polygon(map(element.loops), {.fill = kRock, .stroke = kRock});
  });
  page.layer([&] {
    for (const std::vector<Point>& outline : start.outlines)
      page.polygon({map(outline)}, {.stroke = kOutline, .stroke_width = 1.2});
  });
}

void draw_cracks(SvgPage& page, const PageMap& map, const FieldFrame& end) {
  page.layer([&] {
    for (const CrackFrame& crack : end.cracks)
      page.polyline(map(crack.along), {.stroke = crack.is_shear ? kShear : kPath, .stroke_width = 2});
  });
}

// Displacements that cannot be seen are drawn so large that the greatest is this share of the bodies' size.
constexpr double kSeen = 0.03;

double enlarged_by(const FieldFrame& end, double size) {
  double most = 0;
  for (const FieldElement& element : end.elements)
    for (const auto& loop : element.loops)
      for (const FieldCorner& corner : loop) most = std::max(most, length(corner.displacement));
  return most > 0 && most < kSeen * size ? kSeen * size / most : 1;
}

/// Returns the loops of the elements at the end, with displacements times `factor`.
std::vector<std::vector<std::vector<Point>>> moved(const FieldFrame& end, double factor) {
  std::vector<std::vector<std::vector<Point>>> elements;
  for (const FieldElement& element : end.elements)
    for (auto& loops = elements.emplace_back(); const auto& loop : element.loops) {
      auto& points = loops.emplace_back();
      for (const FieldCorner& corner : loop) points.push_back(corner.position + factor * corner.displacement);
    }
  return elements;
}

/// Returns true if the crack changed its length.
bool grows(const Path& path) {
  return !path.length.empty() && path.length.back() > path.length.front();
}

}  // namespace

std::string crack_picture(const CrackPicture& picture) {
  const auto paths = paths_of(picture.history);
  Box world, end_world;
  for (const ElementFrame& element : picture.start.elements)
    for (const Point p : element.loops.front()) world.include(p);
  const double factor = enlarged_by(picture.end, std::max(world.width(), world.height()));
  const auto elements = moved(picture.end, factor);
  for (const auto& loops : elements)
    for (const Point p : loops.front()) end_world.include(p);
  const double half = (kPageWidth - 3 * kMargin) / 2;
  const PageMap map(world, {kMargin, kTop + kCaption}, {half, kSceneHeight});
  const PageMap end_map(end_world, {2 * kMargin + half, kTop + kCaption}, {half, kSceneHeight});
  std::vector<Curve> factors, factors_k;
  for (const auto& [key, path] : paths) {
    if (factors_k.size() >= 2 * kMostCurves || !grows(path)) continue;
    const std::string name = fmt::format("crack {}, {} end", key.first + 1, key.second ? "last" : "first");
    factors_k.push_back({"K_I " + name, path.length, path.mode_1});
    factors_k.push_back({"K_II " + name, path.length, path.mode_2});
    if (factors.empty() && std::ranges::any_of(path.factor, [](double f) { return f != 1; }))
      factors.push_back({"factor of all loads", path.length, path.factor});
  }
  const double chart_top = kTop + kCaption + std::max(map.size().y, end_map.size().y) + kGap;
  const double charts = (factors_k.empty() ? 0 : 1) + (factors.empty() ? 0 : 1);
  const double height = chart_top + charts * (kChartHeight + kGap);
  SvgPage page(kPageWidth, height);
  page.text({kMargin, 28}, picture.title, {.size = 17, .bold = true});
  page.text({kMargin, kTop + 10}, "cracks in the undeformed bodies; purple: started in shear", {.size = 12});
  page.text({2 * kMargin + half, kTop + 10},
            factor > 1 ? fmt::format("at the end, displacements times {:.3g}", factor) : "at the end", {.size = 12});
  draw_bodies(page, map, picture.start);
  draw_cracks(page, map, picture.end);
  page.layer([&] {
    for (const auto& [key, path] : paths)
      for (const Point p : path.points) page.circle(map(p), 2.2, {.fill = kPath});
  });
  const std::string crack_length = with_unit("length of the crack", measures::kLength, picture.units);
  page.layer([&] {
    for (const auto& loops : elements)
      page.polygon(end_map(loops), {.fill = kRock, .stroke = kEdge, .stroke_width = 0.3});
  });
  if (!factors_k.empty())
    draw_chart(page, {kMargin, chart_top}, {kRoom, kChartHeight}, factors_k,
               {crack_length, with_unit("stress intensity", measures::kToughness, picture.units)});
  if (!factors.empty())
    draw_chart(page, {kMargin, chart_top + kChartHeight + kGap}, {kRoom, kChartHeight}, factors,
               {crack_length, "factor of all loads"});
  return page.str();
}

}  // namespace keyblock::report
