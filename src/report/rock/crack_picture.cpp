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

namespace keyblock::report {
namespace {

constexpr double kPageWidth = 900;
constexpr double kMargin = 30;
constexpr double kTop = 50;
constexpr double kSceneHeight = 420;
constexpr double kChartHeight = 260;
constexpr double kGap = 24;
constexpr std::string_view kRock = "#e8e4da";
constexpr std::string_view kOutline = "#666666";
constexpr std::string_view kPath = "#c0392b";
constexpr std::size_t kMostCurves = 4;  // tips of which curves are drawn: more cannot be told apart

struct Path {
  int first_step = 0;
  std::vector<Point> points;
  std::vector<double> length, mode_1, mode_2, factor;
};

/// Of each crack and end.
std::map<std::pair<int, bool>, Path> paths_of(const History& history) {
  std::map<std::pair<int, bool>, Path> paths;
  for (const HistoryRow& row : history.rows)
    for (const TipState& tip : row.tips) {
      Path& path = paths[{tip.crack, tip.at_end}];
      if (path.points.empty()) path.first_step = row.step;
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
  for (const ElementFrame& element : start.elements) page.polygon(map(element.loops), {.fill = kRock, .stroke = kRock});
  for (const std::vector<Point>& outline : start.outlines)
    page.polygon({map(outline)}, {.stroke = kOutline, .stroke_width = 1.2});
}

/// A crack that started on the way is straight between its first two tips.
void draw_starts(SvgPage& page, const PageMap& map, const std::map<std::pair<int, bool>, Path>& paths) {
  for (const auto& [key, path] : paths) {
    const auto other = paths.find({key.first, !key.second});
    if (!key.second || other == paths.end() || path.first_step <= 1) continue;
    page.polyline({map(other->second.points.front()), map(path.points.front())}, {.stroke = kPath, .stroke_width = 2});
  }
}

/// Whether the crack changed its length.
bool grows(const Path& path) {
  return !path.length.empty() && path.length.back() > path.length.front();
}

}  // namespace

std::string crack_picture(const std::string& title, const Frame& start, const History& history, const Units& units) {
  const auto paths = paths_of(history);
  Box world;
  for (const ElementFrame& element : start.elements)
    for (const Point p : element.loops.front()) world.include(p);
  const PageMap map(world, {kMargin, kTop}, {kPageWidth - 2 * kMargin, kSceneHeight});
  std::vector<Curve> factors, factors_k;
  for (const auto& [key, path] : paths) {
    if (factors_k.size() >= 2 * kMostCurves || !grows(path)) continue;
    const std::string name = fmt::format("crack {}, {} end", key.first + 1, key.second ? "last" : "first");
    factors_k.push_back({"K_I " + name, path.length, path.mode_1});
    factors_k.push_back({"K_II " + name, path.length, path.mode_2});
    if (factors.empty()) factors.push_back({"factor of all loads", path.length, path.factor});
  }
  const double chart_top = kTop + map.size().y + kGap;
  const double height = factors_k.empty() ? chart_top : chart_top + 2 * (kChartHeight + kGap);
  SvgPage page(kPageWidth, height);
  page.text({kMargin, 28}, title, {.size = 17, .bold = true});
  draw_bodies(page, map, start);
  draw_starts(page, map, paths);
  for (const auto& [key, path] : paths) {
    page.polyline(map(path.points), {.stroke = kPath, .stroke_width = 2});
    for (const Point p : path.points) page.circle(map(p), 2.2, {.fill = kPath});
  }
  if (!factors_k.empty()) {
    const std::string length = with_unit("length of the crack", measures::kLength, units);
    draw_chart(page, {kMargin, chart_top}, {kPageWidth - 2 * kMargin, kChartHeight}, factors_k,
               {length, with_unit("stress intensity", measures::kToughness, units)});
    draw_chart(page, {kMargin, chart_top + kChartHeight + kGap}, {kPageWidth - 2 * kMargin, kChartHeight}, factors,
               {length, "factor of all loads"});
  }
  return page.str();
}

}  // namespace keyblock::report
