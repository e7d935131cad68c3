// Marks first, then names where they hide none of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/tradeoff_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "report/drawing/colours.hpp"
#include "report/drawing/plot.hpp"
#include "report/drawing/scene.hpp"
#include "report/page.hpp"

namespace keyblock::report {
namespace {

constexpr double kHeight = 520;
constexpr double kTop = 66;  // titles
constexpr double kRadius = 4;
constexpr double kNameSize = 12;

constexpr std::string_view kFrontColour = line_colour(2);
constexpr std::string_view kProfileColour = line_colour(1);
constexpr std::string_view kOtherColour = "#888888";

Point logarithms(const PricedRun& run) {
  return {std::log10(run.seconds), std::log10(run.error)};
}

/// Rectangles of the page that are taken.
class Taken {
 public:
  explicit Taken(const Box& room) : room_(room) {}

  bool is_free(const Box& box) const {
    if (box.low.x < room_.low.x || box.high.x > room_.high.x || box.low.y < room_.low.y || box.high.y > room_.high.y)
      return false;
    return std::ranges::none_of(boxes_, [&](const Box& other) {
      return box.low.x < other.high.x && other.low.x < box.high.x && box.low.y < other.high.y &&
             other.low.y < box.high.y;
    });
  }
  void add(const Box& box) { boxes_.push_back(box); }

 private:
  Box room_;
  std::vector<Box> boxes_;
};

Box around(Point p, double radius) {
  return {{p.x - radius, p.y - radius}, {p.x + radius, p.y + radius}};
}

/// Draws a name beside its mark: right, left, above or below, near places first.
void draw_name(SvgPage& page, Taken& taken, Point at, const PricedRun& run) {
  const double width = text_width(run.name, kNameSize);
  for (const double away : {6.0, 14.0, 26.0, 40.0})
    for (const Point side : {Point{1, 0}, {1, -1}, {1, 1}, {-1, 0}, {-1, -1}, {-1, 1}, {0, -1}, {0, 1}}) {
      const double left = side.x > 0   ? at.x + kRadius + away * 0.7
                          : side.x < 0 ? at.x - kRadius - away * 0.7 - width
                                       : at.x - width / 2;
      const double middle = at.y + side.y * (away + kRadius);
      const Box box{{left, middle - kNameSize / 2}, {left + width, middle + kNameSize / 2}};
      if (!taken.is_free(box)) continue;
      if (away > 6)
        page.line(at, {std::clamp(at.x, left, left + width), middle - side.y * kNameSize / 2},
                  {.stroke = "#bbbbbb", .stroke_width = 0.8});
      page.text({left, middle + kNameSize / 3}, run.name,
                {.size = kNameSize, .fill = run.is_profile ? kProfileColour : "#222222", .bold = run.is_profile});
      taken.add(box);
      return;
    }
}

// Between the costs of two runs of the front, the error is that of the cheaper one.
void draw_front(SvgPage& page, const Plot& plot, std::vector<PricedRun> front, Taken& taken) {
  if (front.empty()) return;
  std::ranges::sort(front, {}, &PricedRun::seconds);
  std::vector<Point> stairs{plot({logarithms(front.front()).x, plot.y.high()})};
  for (const PricedRun& run : front) {
    const Point p = plot(logarithms(run));
    stairs.push_back({p.x, stairs.back().y});
    stairs.push_back(p);
  }
  stairs.push_back({plot.corner.x + plot.size.x, stairs.back().y});
  page.polyline(stairs, {.stroke = kFrontColour, .stroke_width = 1.5});
  for (std::size_t i = 0; i + 1 < stairs.size(); ++i) {
    Box step;
    step.include(stairs[i]);
    step.include(stairs[i + 1]);
    taken.add(step);
  }
}

void draw_mark(SvgPage& page, Point at, const PricedRun& run) {
  page.begin_group(run.details);
  if (run.is_profile)
    page.rectangle(at - Point{kRadius, kRadius}, 2 * kRadius, 2 * kRadius,
                   {.fill = run.is_on_front || run.is_near_front ? kProfileColour : "#ffffff",
                    .stroke = kProfileColour,
                    .stroke_width = 1.5});
  else
    page.circle(at, run.is_on_front ? kRadius : kRadius - 0.8,
                {.fill = run.is_on_front ? kFrontColour : "#ffffff",
                 .stroke = run.is_on_front ? kFrontColour : kOtherColour,
                 .stroke_width = 1.2});
  page.end_group();
}

void draw_least_error(SvgPage& page, const Plot& plot, double least) {
  const double y = least > 0 ? std::log10(least) : plot.y.low() - 1;
  if (y <= plot.y.low() || y >= plot.y.high()) return;
  page.line(plot({plot.x.low(), y}), plot({plot.x.high(), y}),
            {.stroke = kOtherColour, .stroke_width = 1, .dash = "6 4"});
}

}  // namespace

std::string tradeoff_picture(const TradeoffPicture& picture) {
  SvgPage page(kPageWidth, kHeight);
  page.text({kMargin, 28}, picture.title, {.size = 17, .bold = true});
  page.text({kMargin, 48}, picture.subtitle, {.size = 12});
  if (picture.runs.empty()) return page.str();
  const auto [quickest, slowest] = std::ranges::minmax(picture.runs, {}, &PricedRun::seconds);
  const auto [best, worst] = std::ranges::minmax(picture.runs, {}, &PricedRun::error);
  using Sign = LegendEntry::Sign;
  std::vector<LegendEntry> legend{
      {.sign = Sign::line, .colour = kFrontColour, .words = "front: nothing cheaper is as accurate"},
      {.sign = Sign::dots, .colour = kProfileColour, .words = "profile (square)"},
      {.sign = Sign::dots, .colour = kOtherColour, .words = "other run"}};
  const Axis errors = make_log_axis(best.error / 2, worst.error);
  if (picture.least_error > 0 && std::log10(picture.least_error) > errors.low())
    legend.push_back({.sign = Sign::dashed_line, .colour = kOtherColour, .words = "below: not distinguished"});
  const double width = kRoom - kPlotLeft - kPlotRight;
  const double top = kTop + legend_height(legend, width) + 6;
  const Plot plot{.corner = {kMargin + kPlotLeft, top},
                  .size = {width, kHeight - top - kPlotBottom - 10},
                  .x = make_log_axis(quickest.seconds, slowest.seconds),
                  .y = errors};
  draw_legend(page, {kMargin + kPlotLeft, kTop}, width, legend);
  draw_axes(page, plot, "processor time of the steps [s]", "relative error");
  draw_least_error(page, plot, picture.least_error);
  std::vector<PricedRun> front;
  std::ranges::copy_if(picture.runs, std::back_inserter(front), &PricedRun::is_on_front);
  Taken taken({plot.corner, plot.corner + plot.size});
  draw_front(page, plot, front, taken);
  for (const bool is_profile : {false, true})
    for (const PricedRun& run : picture.runs) {
      if (run.is_profile != is_profile) continue;
      const Point at = plot(logarithms(run));
      draw_mark(page, at, run);
      taken.add(around(at, kRadius));
    }
  for (const bool is_profile : {true, false})
    for (const PricedRun& run : picture.runs)
      if (run.is_profile == is_profile && (is_profile || run.is_on_front))
        draw_name(page, taken, plot(logarithms(run)), run);
  return page.str();
}

}  // namespace keyblock::report
