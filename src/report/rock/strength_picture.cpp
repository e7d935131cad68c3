// Two panels and a chart; see strength_picture.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/rock/strength_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/counted.hpp"
#include "problem/units/measure.hpp"
#include "report/drawing/colours.hpp"
#include "report/drawing/plot.hpp"
#include "report/drawing/scene.hpp"
#include "report/drawing/svg.hpp"
#include "report/page.hpp"

namespace keyblock::report {
namespace {

constexpr double kCaption = 13;
constexpr double kCaptionRoom = 26;
constexpr double kBelow = 22;  // from the lower panel to the scale bar
constexpr double kPanelHeight = 330;
constexpr std::size_t kMostArrows = 240;
constexpr double kArrow = 34;        // page units, of the largest increment
constexpr double kShownSlip = 0.02;  // of the largest increment: less is not drawn
constexpr double kSameLine = 1e-6;   // of the extent
constexpr std::size_t kMostEdges = 6'000;
constexpr double kGap = 18;
constexpr double kTallHeight = 460;  // of panels side by side
constexpr std::string_view kSlipColour = "#b2182b";
constexpr std::string_view kArrowColour = "#222222";

std::vector<std::vector<Point>> outline(const FieldElement& element, double factor) {
  std::vector<std::vector<Point>> loops;
  for (const auto& loop : element.loops) {
    auto& out = loops.emplace_back();
    for (const FieldCorner& corner : loop) out.push_back(corner.position + factor * corner.displacement);
  }
  return loops;
}

Box box_of(const FieldFrame& field) {
  Box box;
  for (const FieldElement& element : field.elements)
    for (const FieldCorner& corner : element.loops.front()) box.include(corner.position);
  return box;
}

std::string heat(double share) {
  return hex(colour_at(palette::kRising, share));
}

// Draws the least value, the bar, the greatest value and their name in one line.
void draw_heat_bar(SvgPage& page, Point corner, const std::string& most, const std::string& words) {
  constexpr int kParts = 30;
  page.text(corner + Point{-6, 10}, "0", {.size = 12, .anchor = Anchor::end});
  for (int i = 0; i < kParts; ++i)
    page.rectangle(corner + Point{4.0 * i, 0}, 4.4, 10, {.fill = heat((i + 0.5) / kParts)});
  page.text(corner + Point{4.0 * kParts + 8, 10}, most + "  " + words, {.size = 12});
}

std::string force_words(double force, const Units& units) {
  const bool is_named = is_declared(measures::kForce, units);
  return is_named ? fmt::format("{:.3g} {}", force, unit_of(measures::kForce, units)) : fmt::format("{:.3g}", force);
}

// Draws bolts with their force; only a few numbers, which otherwise hide each other.
void draw_bolts(SvgPage& page, const PageMap& map, const StrengthPicture& picture, bool with_forces) {
  constexpr std::size_t kMostNumbers = 12;
  constexpr std::string_view kAtStrength = "#b2182b";
  const bool has_numbers = with_forces && picture.bolts.size() <= kMostNumbers;
  for (const StrengthBolt& bolt : picture.bolts) {
    const bool is_red = with_forces && bolt.is_at_strength;
    page.line(map(bolt.at.start), map(bolt.at.end), {.stroke = is_red ? kAtStrength : kBoltColour, .stroke_width = 2});
    if (!has_numbers) continue;
    const bool goes_left = bolt.at.end.x < bolt.at.start.x;
    page.text(map(bolt.at.start) + Point{goes_left ? 5.0 : -5.0, 4},
              force_words(bolt.force, picture.units) + (is_red ? " (at its strength)" : ""),
              {.size = 11,
               .anchor = goes_left ? Anchor::start : Anchor::end,
               .fill = is_red ? kAtStrength : kBoltColour,
               .bold = true});
  }
}

std::string bolts_in_words(const StrengthPicture& picture) {
  if (picture.bolts.empty()) return {};
  const auto spent = static_cast<std::size_t>(std::ranges::count_if(picture.bolts, &StrengthBolt::is_at_strength));
  return fmt::format("; {}, {} at full strength (red)", counted(picture.bolts.size(), "bolt"), spent);
}

/// An edge of an element as it lay at the start.
struct Side {
  const FieldElement* element;
  const FieldElement* now;
  std::size_t loop;
  std::size_t corner;

  const FieldCorner& begin(const FieldElement& of) const { return of.loops[loop][corner]; }
  const FieldCorner& end(const FieldElement& of) const { return of.loops[loop][(corner + 1) % of.loops[loop].size()]; }
  Point increment(double share) const {
    const Point first = begin(*now).displacement - begin(*element).displacement;
    const Point last = end(*now).displacement - end(*element).displacement;
    return first + share * (last - first);
  }
};

std::vector<Side> sides_of(const FieldFrame& before, const FieldFrame& after) {
  std::vector<Side> sides;
  for (std::size_t e = 0; e < before.elements.size(); ++e)
    for (std::size_t l = 0; l < before.elements[e].loops.size(); ++l)
      for (std::size_t c = 0; c < before.elements[e].loops[l].size(); ++c)
        sides.push_back({&before.elements[e], &after.elements[e], l, c});
  return sides;
}

// Returns the stretch that two sides share, if they lie along each other in opposite senses.
std::optional<SlipLine> shared(const Side& one, const Side& other, double near) {
  const Point a = one.begin(*one.element).position, b = one.end(*one.element).position;
  const Point c = other.begin(*other.element).position, d = other.end(*other.element).position;
  const Point way = b - a;
  const double size = length(way);
  if (!(size > near)) return std::nullopt;
  const Point along = (1 / size) * way;
  const Point normal{-along.y, along.x};  // into the element on the left
  if (std::abs(dot(c - a, normal)) > near || std::abs(dot(d - a, normal)) > near) return std::nullopt;
  const double from = std::max(0.0, dot(d - a, along)), to = std::min(size, dot(c - a, along));
  if (!(to - from > near)) return std::nullopt;
  const double middle = (from + to) / 2;
  const double whole = dot(c - a, along) - dot(d - a, along);
  const Point apart = one.increment(middle / size) - other.increment((dot(c - a, along) - middle) / whole);
  return SlipLine{a + from * along, a + to * along, dot(apart, along), dot(apart, normal)};
}

double largest_increment(const FieldFrame& before, const FieldFrame& after) {
  double most = 0;
  for (std::size_t e = 0; e < before.elements.size(); ++e)
    for (std::size_t l = 0; l < before.elements[e].loops.size(); ++l)
      for (std::size_t c = 0; c < before.elements[e].loops[l].size(); ++c)
        most = std::max(
            most, length(after.elements[e].loops[l][c].displacement - before.elements[e].loops[l][c].displacement));
  return most;
}

void draw_arrow(SvgPage& page, Point from, Point way) {
  const double size = length(way);
  if (size < 2) return;
  const Point along = (1 / size) * way, across{-along.y, along.x};
  const Point tip = from + way;
  const double head = std::min(6.0, size / 2);
  page.line(from, tip, {.stroke = kArrowColour, .stroke_width = 1});
  page.polygon({{tip, tip - head * along + 0.4 * head * across, tip - head * along - 0.4 * head * across}},
               {.fill = kArrowColour});
}

/// State of the model on the page.
struct Panel {
  Panel(const Box& box, Point corner, Point room, Point caption_at, Point bar_from_caption)
      : map(box, corner, room),
        caption(caption_at),
        bar(caption_at + bar_from_caption),
        bottom(corner.y + map.size().y) {}

  PageMap map;
  Point caption;
  Point bar;  ///< of colours
  double bottom;
};

/// Places both states one above the other; side by side if that shows them larger, or nearly as large.
std::array<Panel, 2> place_panels(const Box& box, const StrengthPicture& picture) {
  constexpr double kNearly = 0.8;
  constexpr Point kBesideCaption{240, -10}, kBelowCaption{14, 10};
  const Point corner{kMargin, kTitleHeight + kCaptionRoom}, caption = corner - Point{0, 10};
  const Panel upper(box, corner, {kRoom, kPanelHeight}, caption, kBesideCaption);
  const Point half{(kRoom - kGap) / 2, kTallHeight}, below_bar = corner + Point{0, kCaptionRoom};
  const Panel left(box, below_bar, half, caption, kBelowCaption);
  const double words = text_width(picture.standing_words + bolts_in_words(picture), kCaption);
  if (left.map.scale() < kNearly * upper.map.scale() || words > half.x) {
    const Point down{0, upper.map.size().y + kCaptionRoom + 14};
    return {upper, Panel(box, corner + down, {kRoom, kPanelHeight}, caption + down, kBesideCaption)};
  }
  const Point across{half.x + kGap, 0};
  return {left, Panel(box, below_bar + across, half, caption + across, kBelowCaption)};
}

void draw_standing(SvgPage& page, const Panel& panel, const StrengthPicture& picture) {
  const PageMap& map = panel.map;
  double most = 0;
  for (const double strain : picture.plastic_strains) most = std::max(most, strain);
  const bool has_flow = most > 0;
  const double width = std::min(0.6, edge_width(map.size(), picture.standing.elements.size()));
  page.layer([&] {
    for (std::size_t e = 0; e < picture.standing.elements.size(); ++e) {
      const FieldElement& element = picture.standing.elements[e];
      const std::string colour =
          has_flow ? heat(picture.plastic_strains.at(e) / most) : std::string(area_colour(element.material));
      page.polygon(map(outline(element, 0)), {.fill = colour, .stroke = "#777777", .stroke_width = width});
    }
  });
  page.layer([&] { draw_bolts(page, map, picture, true); });
  page.text(panel.caption, picture.standing_words + bolts_in_words(picture), {.size = kCaption, .bold = true});
  if (has_flow) draw_heat_bar(page, panel.bar, fmt::format("{:.2g}", most), "plastic strain");
}

void draw_falling(SvgPage& page, const Panel& panel, const StrengthPicture& picture) {
  const PageMap& map = panel.map;
  page.text(panel.caption, picture.falling_words, {.size = kCaption, .bold = true});
  if (!picture.falling || picture.falling->elements.size() != picture.before.elements.size()) return;
  const FieldFrame& before = picture.before;
  const FieldFrame& after = *picture.falling;
  const double most = largest_increment(before, after);
  if (!(most > 0)) return;
  const double width = std::min(0.6, edge_width(map.size(), before.elements.size()));
  const auto increment = [&](std::size_t e) {
    return after.elements[e].middle.displacement - before.elements[e].middle.displacement;
  };
  page.layer([&] {
    for (std::size_t e = 0; e < before.elements.size(); ++e)
      page.polygon(map(outline(before.elements[e], 0)),
                   {.fill = heat(length(increment(e)) / most), .stroke = "#999999", .stroke_width = width});
  });
  for (const SlipLine& line : slip_lines(before, after)) {
    const double share = std::hypot(line.slip, line.opening) / most;
    if (share < kShownSlip) continue;
    page.begin_group(fmt::format("slip {:.3g}, opening {:.3g}", line.slip, line.opening));
    page.line(map(line.from), map(line.to), {.stroke = kSlipColour, .stroke_width = 1.5 + 3 * std::min(1.0, share)});
    page.end_group();
  }
  const std::size_t every = before.elements.size() / kMostArrows + 1;
  for (std::size_t e = 0; e < before.elements.size(); e += every) {
    const Point way = (kArrow / most) * increment(e);
    draw_arrow(page, map(before.elements[e].middle.position), {way.x, -way.y});
  }
  page.layer([&] { draw_bolts(page, map, picture, false); });
  draw_heat_bar(page, panel.bar, "1", "displacement increment over the largest");
  page.text({kMargin + kRoom, panel.bottom + kBelow}, "red lines: joints that slip or open",
            {.size = 12, .anchor = Anchor::end});
}

constexpr double kStrip = 22;  // above the axes, of trials without a displacement
constexpr std::string_view kStandsColour = "#0072b2";
constexpr std::string_view kFallsColour = "#b2182b";
constexpr std::string_view kUndecidedColour = "#777777";
constexpr std::string_view kServiceColour = "#8a6d3b";
constexpr std::string_view kBracketColour = "#fde3d3";

std::string_view colour_of(StrengthPoint::Kind kind) {
  if (kind == StrengthPoint::Kind::stands) return kStandsColour;
  return kind == StrengthPoint::Kind::falls ? kFallsColour : kUndecidedColour;
}

std::vector<LegendEntry> chart_legend(const std::vector<StrengthPoint>& points, const StrengthChart& chart) {
  using Kind = StrengthPoint::Kind;
  const auto has = [&](Kind kind) { return std::ranges::count(points, kind, &StrengthPoint::kind) > 0; };
  using Sign = LegendEntry::Sign;
  std::vector<LegendEntry> legend;
  if (has(Kind::stands)) legend.push_back({.sign = Sign::dots, .colour = kStandsColour, .words = "stable"});
  if (has(Kind::falls))
    legend.push_back({.sign = Sign::line, .colour = kFallsColour, .words = "× unstable (displacement not drawn)"});
  if (has(Kind::undecided)) legend.push_back({.sign = Sign::line, .colour = kUndecidedColour, .words = "× undecided"});
  if (chart.stands && chart.falls)
    legend.push_back({.sign = Sign::area,
                      .colour = kBracketColour,
                      .words = fmt::format("stable up to {:.4g}, unstable from {:.4g}", *chart.stands, *chart.falls)});
  if (chart.service)
    legend.push_back({.sign = Sign::dashed_line,
                      .colour = kServiceColour,
                      .words = fmt::format("displacements grow from {:.4g}", *chart.service)});
  return legend;
}

void draw_bracket(SvgPage& page, const Plot& plot, const StrengthChart& chart) {
  const double top = plot.corner.y - kStrip;
  if (chart.stands && chart.falls) {
    const double left = plot({*chart.stands, 0}).x, right = plot({*chart.falls, 0}).x;
    page.rectangle({left, top}, std::max(1.5, right - left), plot.size.y + kStrip, {.fill = kBracketColour});
  }
  if (!chart.service) return;
  const double x = plot({*chart.service, 0}).x;
  page.line({x, top}, {x, plot.corner.y + plot.size.y}, {.stroke = kServiceColour, .stroke_width = 1.2, .dash = "4 3"});
}

// Draws stable trials at their displacement, on a line, and the others as crosses in the strip above the axes.
void draw_trials(SvgPage& page, const Plot& plot, const std::vector<StrengthPoint>& points) {
  std::vector<Point> line;
  for (const StrengthPoint& point : points)
    if (point.kind == StrengthPoint::Kind::stands) line.push_back(plot({point.factor, point.displacement}));
  page.polyline(line, {.stroke = kStandsColour, .stroke_width = 2});
  for (const Point p : line) page.circle(p, 3.2, {.fill = "#ffffff", .stroke = kStandsColour, .stroke_width = 1.5});
  constexpr double kArm = 3.5;
  for (const StrengthPoint& point : points) {
    if (point.kind == StrengthPoint::Kind::stands) continue;
    const Point p{plot({point.factor, 0}).x, plot.corner.y - kStrip / 2};
    const Style style{.stroke = colour_of(point.kind), .stroke_width = 2};
    page.begin_group(fmt::format("F = {:.6g}", point.factor));
    page.line(p - Point{kArm, kArm}, p + Point{kArm, kArm}, style);
    page.line(p + Point{-kArm, kArm}, p + Point{kArm, -kArm}, style);
    page.end_group();
  }
}

}  // namespace

std::vector<SlipLine> slip_lines(const FieldFrame& before, const FieldFrame& after) {
  std::vector<SlipLine> lines;
  if (before.elements.size() != after.elements.size()) return lines;
  const std::vector<Side> sides = sides_of(before, after);
  if (sides.size() > kMostEdges) return lines;
  const Box box = box_of(before);
  const double near = kSameLine * std::hypot(box.width(), box.height());
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      if (sides[i].element->body == sides[j].element->body) continue;
      if (const auto line = shared(sides[i], sides[j], near)) lines.push_back(*line);
    }
  return lines;
}

std::string strength_picture(const StrengthPicture& picture) {
  const Box box = box_of(picture.standing.elements.empty() ? picture.before : picture.standing);
  const auto [first, second] = place_panels(box, picture);
  SvgPage page(kPageWidth, second.bottom + 50);
  page.text({kMargin, 28}, picture.title, {.size = 17, .bold = true});
  if (box.empty()) return page.str();
  draw_standing(page, first, picture);
  draw_falling(page, second, picture);
  draw_scale_bar(page, {kMargin, second.bottom + kBelow}, kRoom, first.map, picture.units);
  return page.str();
}

std::string strength_chart(const StrengthChart& chart) {
  constexpr double kWidth = 700, kHeight = 460, kTop = 50;
  SvgPage page(kWidth, kHeight);
  page.text({kMargin, 28}, chart.title, {.size = 17, .bold = true});
  if (chart.points.empty()) return page.str();
  std::vector<StrengthPoint> points = chart.points;
  std::ranges::sort(points, {}, &StrengthPoint::factor);
  const std::vector<LegendEntry> legend = chart_legend(points, chart);
  const double width = kWidth - 2 * kMargin - kPlotLeft - kPlotRight;
  const double strip = kTop + legend_height(legend, width) + 6;
  double most = 0;
  for (const StrengthPoint& point : points)
    if (point.kind == StrengthPoint::Kind::stands) most = std::max(most, point.displacement);
  const Plot plot{.corner = {kMargin + kPlotLeft, strip + kStrip},
                  .size = {width, kHeight - strip - kStrip - kPlotBottom - 14},
                  .x = make_axis(points.front().factor, points.back().factor, static_cast<int>(width / 90)),
                  .y = make_axis(0, most > 0 ? most : 1, 5)};
  draw_legend(page, {kMargin + kPlotLeft, kTop}, width, legend);
  draw_bracket(page, plot, chart);
  draw_axes(page, plot, "factor that strength is divided by",
            with_unit("largest displacement", measures::kLength, chart.units));
  draw_trials(page, plot, points);
  return page.str();
}

}  // namespace keyblock::report
