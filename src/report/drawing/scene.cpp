// Signs, legend and scale bar, in page units; sizes chosen for a page about 900 units wide.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problem/units/readable.hpp"
#include "report/drawing/colours.hpp"
#include "report/drawing/ticks.hpp"

namespace keyblock::report {
namespace {

constexpr std::size_t kLegendLimit = 12;
constexpr double kRow = 20;
constexpr double kSignWidth = 26;
constexpr double kEntryGap = 18;
constexpr double kNameGap = 5;  // from the end of a bolt
constexpr std::string_view kIdleBoltColour = "#777777";
constexpr std::string_view kBrokenColour = "#d00000";
constexpr double kPlate = 4;  // half of the plate at an end of a bolt
constexpr double kGap = 5;    // half of that in a broken one
constexpr double kCross = 3.5;
constexpr double kTextSize = 12;
constexpr double kFarAway = 0.1;     // of the diagonal of what was drawn, beyond it
constexpr double kFewOfMany = 0.05;  // of the number of all blocks
constexpr double kSmallPart = 0.05;  // of their area: eight blocks that fell off a slope of 211 are 2 %

void draw_fixed_point(SvgPage& page, Point p) {
  page.polygon({{p, {p.x - 5, p.y + 9}, {p.x + 5, p.y + 9}}},
               {.fill = "#222222", .stroke = "#ffffff", .stroke_width = 0.8});
}

void draw_loading_point(SvgPage& page, Point p) {
  page.polygon({{{p.x, p.y - 6}, {p.x + 6, p.y}, {p.x, p.y + 6}, {p.x - 6, p.y}}},
               {.fill = "#d55e00", .stroke = "#ffffff", .stroke_width = 0.8});
}

void draw_measured_point(SvgPage& page, Point p) {
  page.circle(p, 4, {.fill = "#ffffff", .stroke = "#0072b2", .stroke_width = 1.8});
}

double entry_width(const LegendEntry& entry) {
  return kSignWidth + text_width(entry.words, kTextSize) + kEntryGap;
}

/// Returns the start of each entry in rows: x from the left, y from the top of the first row.
std::vector<Point> place_entries(const std::vector<LegendEntry>& entries, double width) {
  std::vector<Point> places;
  Point next;
  for (const LegendEntry& entry : entries) {
    if (next.x > 0 && next.x + entry_width(entry) > width) next = {0, next.y + kRow};
    places.push_back(next);
    next.x += entry_width(entry);
  }
  return places;
}

void draw_sign(SvgPage& page, Point left, const LegendEntry& entry) {
  const Point middle = left + Point{9, 0};
  switch (entry.sign) {
    case LegendEntry::Sign::area:
      page.rectangle(left + Point{2, -6}, 14, 12, {.fill = entry.colour, .stroke = "#555555", .stroke_width = 0.8});
      break;
    case LegendEntry::Sign::line:
      page.line(left, left + Point{18, 0}, {.stroke = entry.colour, .stroke_width = 2});
      break;
    case LegendEntry::Sign::dashed_line:
      page.line(left, left + Point{18, 0}, {.stroke = entry.colour, .stroke_width = 1.2, .dash = "4 3"});
      break;
    case LegendEntry::Sign::dots:
      page.circle(middle, 3.2, {.fill = "#ffffff", .stroke = entry.colour, .stroke_width = 1.5});
      break;
    case LegendEntry::Sign::mark:
      draw_mark(page, entry.mark == Mark::fixed_point ? middle - Point{0, 5} : middle, entry.mark);
      break;
    case LegendEntry::Sign::bolt:
      draw_bolt(page, left, left + Point{20, 0}, entry.bolt);
      break;
    case LegendEntry::Sign::number:
      page.text(middle + Point{0, 4}, "1",
                {.size = kTextSize, .anchor = Anchor::middle, .fill = entry.colour, .bold = true});
      break;
  }
}

}  // namespace

void draw_mark(SvgPage& page, Point at, Mark mark) {
  switch (mark) {
    case Mark::fixed_point:
      return draw_fixed_point(page, at);
    case Mark::loading_point:
      return draw_loading_point(page, at);
    case Mark::measured_point:
      return draw_measured_point(page, at);
  }
}

void draw_bolt(SvgPage& page, Point from, Point to, BoltState state, const std::string& name) {
  const Point along = to - from;
  const Point unit = length(along) > 0 ? (1 / length(along)) * along : Point{1, 0};
  const Point across = kPlate * Point{-unit.y, unit.x};
  const Style style{.stroke = state == BoltState::idle ? kIdleBoltColour : kBoltColour, .stroke_width = 2};
  if (state == BoltState::idle) {
    page.line(from, to, {.stroke = style.stroke, .stroke_width = 2, .dash = "1.5 3"});
  } else if (state == BoltState::broken) {
    const Point middle = from + 0.5 * along;
    const Point half_gap = std::min(kGap, length(along) / 4) * unit;
    page.line(from, middle - half_gap, style);
    page.line(middle + half_gap, to, style);
    const Style cross{.stroke = kBrokenColour, .stroke_width = 2};
    page.line(middle - Point{kCross, kCross}, middle + Point{kCross, kCross}, cross);
    page.line(middle - Point{kCross, -kCross}, middle + Point{kCross, -kCross}, cross);
  } else {
    page.line(from, to, style);
  }
  for (const Point end : {from, to})
    if (state != BoltState::idle) page.line(end - across, end + across, style);
  if (name.empty()) return;
  const bool goes_left = to.x < from.x;
  page.text({to.x + (goes_left ? -kNameGap : kNameGap), to.y + (to.y > from.y ? kNameGap : -kNameGap)}, name,
            {.size = 11, .anchor = goes_left ? Anchor::end : Anchor::start, .fill = style.stroke});
}

void add_bolts(std::vector<LegendEntry>& legend, const std::vector<BoltState>& states) {
  for (const auto& [state, words] : {std::pair{BoltState::carries, "bolt"},
                                     {BoltState::broken, "broken bolt"},
                                     {BoltState::idle, "bolt without properties, carries nothing"}})
    if (const auto count = std::ranges::count(states, state); count > 0)
      legend.push_back({.sign = LegendEntry::Sign::bolt,
                        .colour = {},
                        .words = fmt::format("{} ({})", words, count),
                        .bolt = state});
}

std::vector<std::size_t> far_small_blocks(const Box& drawn, const std::vector<PlacedBlock>& blocks) {
  const double away = kFarAway * std::hypot(drawn.width(), drawn.height());
  std::vector<std::size_t> found;
  double of_found = 0, of_all = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Point& at = blocks[i].middle;
    of_all += blocks[i].area;
    const bool is_near = at.x >= drawn.low.x - away && at.x <= drawn.high.x + away && at.y >= drawn.low.y - away &&
                         at.y <= drawn.high.y + away;
    if (is_near || blocks[i].stays) continue;
    of_found += blocks[i].area;
    found.push_back(i);
  }
  const bool are_few = static_cast<double>(found.size()) <= kFewOfMany * static_cast<double>(blocks.size());
  return are_few && of_found <= kSmallPart * of_all ? found : std::vector<std::size_t>();
}

std::string outside_in_words(std::size_t count) {
  return fmt::format("{} outside of the picture",
                     count == 1 ? "1 small block lies" : fmt::format("{} small blocks lie", count));
}

double edge_width(Point page_size, std::size_t block_count) {
  const double area = page_size.x * page_size.y / static_cast<double>(std::max<std::size_t>(block_count, 1));
  return std::clamp(0.05 * std::sqrt(area), 0.15, 1.2);
}

double legend_height(const std::vector<LegendEntry>& entries, double width) {
  return entries.empty() ? 0 : place_entries(entries, width).back().y + kRow;
}

void draw_legend(SvgPage& page, Point corner, double width, const std::vector<LegendEntry>& entries) {
  const std::vector<Point> places = place_entries(entries, width);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Point left = corner + places[i] + Point{0, kRow / 2};
    draw_sign(page, left, entries[i]);
    page.text(left + Point{kSignWidth, 4}, entries[i].words, {.size = kTextSize});
  }
}

void draw_joint_edges(SvgPage& page, const std::vector<Point>& corners, const std::vector<int>& joints, double width) {
  if (corners.size() < 2) return;
  std::vector<Point> run{corners.back()};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    run.push_back(corners[i]);
    const bool is_last = i + 1 == corners.size();
    if (!is_last && joints[i + 1] == joints[i]) continue;
    if (joints[i] >= 0) page.polyline(run, {.stroke = line_colour(joints[i]), .stroke_width = width});
    run.assign(1, run.back());
  }
}

void add_numbered(std::vector<LegendEntry>& legend, const std::set<int>& numbers, LegendEntry::Sign sign,
                  std::string_view word, const std::vector<std::string>& names) {
  std::size_t shown = 0;
  for (int number : numbers) {
    if (++shown > kLegendLimit) {
      legend.push_back({.sign = LegendEntry::Sign::area,
                        .colour = "#ffffff",
                        .words = fmt::format("and {} more", numbers.size() - kLegendLimit)});
      return;
    }
    const std::string_view colour = sign == LegendEntry::Sign::area ? area_colour(number) : line_colour(number);
    const auto at = static_cast<std::size_t>(number);
    const bool has_name = number >= 0 && at < names.size() && !names[at].empty();
    const std::string plain = fmt::format("{} {}", word, number + 1);
    legend.push_back(
        {.sign = sign, .colour = colour, .words = has_name ? fmt::format("{} ({})", names[at], plain) : plain});
  }
}

void draw_scale_bar(SvgPage& page, Point left, double width, const PageMap& map, const Units& units) {
  const double length = round_down(0.25 * width / map.scale());
  const Point right{left.x + length * map.scale(), left.y};
  const Style bar{.stroke = "#222222", .stroke_width = 1.6};
  page.line(left, right, bar);
  for (Point end : {left, right}) page.line(end - Point{0, 4}, end + Point{0, 4}, bar);
  page.text(right + Point{8, 4},
            units.length.empty() ? fmt::format("{:g} (unit of length of the input)", length)
                                 : readable(length, measures::kLength, units),
            {.size = kTextSize});
}

}  // namespace keyblock::report
