// Keys that are not numbers stand in the order in which they come first.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/values_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/counted.hpp"
#include "report/drawing/chart.hpp"
#include "report/drawing/colours.hpp"
#include "report/drawing/plot.hpp"
#include "report/page.hpp"

namespace keyblock::report {
namespace {

constexpr double kPanel = 360;
constexpr double kTop = 66;
constexpr double kBar = 110;
constexpr std::size_t kMostPanels = 6;
constexpr std::size_t kMostWords = 6;  // beside the name of an axis
constexpr double kAround = 0.05;       // of the range of a key: room for marks at its ends

bool is_numeric(const ValuesColumn& column) {
  return std::ranges::any_of(column.numbers, [](double number) { return std::isfinite(number); });
}

bool has_places(const ValuesColumn& key) {
  return std::ranges::all_of(key.numbers, [](double number) { return std::isfinite(number); });
}

/// Returns the name of an axis; if its places are an order of words, with the first of these: "(1: sand, 2: clay)".
std::string axis_name(const ValuesColumn& key) {
  if (has_places(key)) return key.name;
  std::vector<std::string> known;
  for (const std::string& word : key.words)
    if (std::ranges::find(known, word) == known.end()) known.push_back(word);
  std::string words;
  for (std::size_t i = 0; i < std::min(known.size(), kMostWords); ++i)
    words += fmt::format("{}{}: {}", i == 0 ? "" : ", ", i + 1, known[i]);
  return fmt::format("{} ({}{})", key.name, words, known.size() > kMostWords ? ", …" : "");
}

/// Returns numbers along an axis: of the key, or of the order of its words.
std::vector<double> places_of(const ValuesColumn& key) {
  if (has_places(key)) return key.numbers;
  std::vector<std::string> known;
  std::vector<double> places;
  for (const std::string& word : key.words) {
    const auto found = std::ranges::find(known, word);
    places.push_back(static_cast<double>(found - known.begin()) + 1);
    if (found == known.end()) known.push_back(word);
  }
  return places;
}

void draw_panel(SvgPage& page, Point corner, const ValuesColumn& key, const ValuesColumn& output) {
  const std::vector<double> places = places_of(key);
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return places[i]; });
  Curve line{"", {}, {}};
  for (const std::size_t i : order) {
    if (!std::isfinite(output.numbers[i])) continue;
    line.x.push_back(places[i]);
    line.y.push_back(output.numbers[i]);
  }
  Curve points = line;
  points.style = Curve::Style::points;
  points.colour = line.colour = 2;
  draw_chart(page, corner, {kRoom, kPanel - 20}, {line, points}, {axis_name(key), output.name});
}

/// Map of one output over two keys.
struct Map {
  std::vector<double> x;
  std::vector<double> y;
  const ValuesColumn& output;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;

  double share(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

Map map_of(const ValuesPicture& picture, const ValuesColumn& output) {
  Map map{places_of(picture.keys[0]), places_of(picture.keys[1]), output};
  for (const double value : output.numbers) {
    if (!std::isfinite(value)) continue;
    map.low = std::min(map.low, value);
    map.high = std::max(map.high, value);
  }
  return map;
}

void draw_bar(SvgPage& page, Point corner, double height, const Map& map) {
  constexpr int kSteps = 48;
  page.text({kPageWidth - kMargin, corner.y - 20}, map.output.name, {.size = 12, .anchor = Anchor::end, .bold = true});
  for (int i = 0; i < kSteps; ++i)
    page.rectangle({corner.x, corner.y + height * i / kSteps}, 14, height / kSteps + 0.4,
                   {.fill = hex(colour_at(palette::kViridis, 1 - (i + 0.5) / kSteps))});
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
    page.text({corner.x + 20, corner.y + share * height + 4},
              fmt::format("{:.3g}", std::lerp(map.high, map.low, share)), {.size = 11});
}

void draw_map(SvgPage& page, Point corner, const ValuesPicture& picture, const Map& map) {
  const auto [left, right] = std::ranges::minmax(map.x);
  const auto [bottom, top] = std::ranges::minmax(map.y);
  const Plot plot{.corner = corner + Point{kPlotLeft, 10},
                  .size = {kRoom - kPlotLeft - kBar, kPanel - 30 - kPlotBottom},
                  .x = make_axis(left - kAround * (right - left), right + kAround * (right - left), 7),
                  .y = make_axis(bottom - kAround * (top - bottom), top + kAround * (top - bottom), 5)};
  draw_axes(page, plot, axis_name(picture.keys[0]), axis_name(picture.keys[1]));
  const double half = std::clamp(120 / std::sqrt(static_cast<double>(map.x.size())), 2.5, 14.0);
  for (std::size_t i = 0; i < map.x.size(); ++i) {
    const Point at = plot({map.x[i], map.y[i]});
    const double value = map.output.numbers[i];
    page.begin_group(fmt::format("{}: {}, {}: {}, {}: {:.6g}, {}", picture.keys[0].name, picture.keys[0].words[i],
                                 picture.keys[1].name, picture.keys[1].words[i], map.output.name, value,
                                 picture.verdicts[i]));
    if (std::isfinite(value)) {
      page.rectangle(
          at - Point{half, half}, 2 * half, 2 * half,
          {.fill = hex(colour_at(palette::kViridis, map.share(value))), .stroke = "#ffffff", .stroke_width = 0.8});
    } else {
      page.line(at - Point{half, half}, at + Point{half, half}, {.stroke = "#9c1c1c", .stroke_width = 1.2});
      page.line(at + Point{-half, half}, at + Point{half, -half}, {.stroke = "#9c1c1c", .stroke_width = 1.2});
    }
    page.end_group();
  }
  draw_bar(page, {plot.corner.x + plot.size.x + 24, plot.corner.y + 14}, plot.size.y - 14, map);
}

std::string subtitle_of(const ValuesPicture& picture) {
  const auto finished = std::ranges::count(picture.verdicts, "finished");
  return fmt::format("{}, {} finished without a doubt", counted(picture.verdicts.size(), "run"), finished);
}

}  // namespace

std::string values_picture(const ValuesPicture& picture) {
  if (picture.keys.empty() || picture.keys.size() > 2) return {};
  std::vector<const ValuesColumn*> shown;
  for (const ValuesColumn& output : picture.outputs)
    if (is_numeric(output) && shown.size() < kMostPanels) shown.push_back(&output);
  if (shown.empty()) return {};
  SvgPage page(kPageWidth, kTop + kPanel * static_cast<double>(shown.size()));
  page.text({kMargin, 28}, picture.title, {.size = 17, .bold = true});
  page.text({kMargin, 48}, subtitle_of(picture), {.size = 12});
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const Point corner{kMargin, kTop + kPanel * static_cast<double>(i)};
    if (picture.keys.size() == 1)
      draw_panel(page, corner, picture.keys[0], *shown[i]);
    else
      draw_map(page, corner, picture, map_of(picture, *shown[i]));
  }
  return page.str();
}

}  // namespace keyblock::report
