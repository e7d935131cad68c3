// Panels of one size under one title; see field_picture.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/field_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "base/counted.hpp"
#include "report/drawing/colours.hpp"
#include "report/drawing/scene.hpp"
#include "report/drawing/svg.hpp"
#include "report/drawing/ticks.hpp"
#include "report/page.hpp"

namespace keyblock::report {
namespace {

constexpr double kGap = 18;
constexpr double kCaption = 24;
constexpr double kBarWidth = 92;       // colour bar with its numbers
constexpr double kLargestMove = 0.08;  // of the extent, in the deformed mesh
constexpr double kExtreme = 0.005;     // share of triangles beyond either end of the colours
constexpr std::string_view kMeshColour = "#333333";

using Place = std::function<Point(const FieldCorner&)>;

Point as_drawn(const FieldCorner& corner) {
  return corner.position;
}

double component(const Stress& stress, StressShown shown) {
  switch (shown) {
    case StressShown::xx:
      return stress.xx;
    case StressShown::yy:
      return stress.yy;
    case StressShown::xy:
      return stress.xy;
  }
  return 0;
}

std::string_view name_of(StressShown shown) {
  constexpr std::array<std::string_view, 3> kNames{"σxx", "σyy", "σxy"};
  return kNames[static_cast<std::size_t>(shown)];
}

/// Calls `visit(corner)` with every corner.
template <class Visit>
void visit_corners(const FieldFrame& field, Visit visit) {
  for (const FieldElement& element : field.elements)
    for (const auto& loop : element.loops)
      for (const FieldCorner& corner : loop) visit(corner);
}

Box bounds(const FieldFrame& field, const Place& place) {
  Box box;
  visit_corners(field, [&](const FieldCorner& corner) { box.include(place(corner)); });
  return box;
}

std::vector<std::vector<Point>> loops_of(const FieldElement& element, const Place& place) {
  std::vector<std::vector<Point>> loops;
  for (const auto& loop : element.loops) {
    loops.emplace_back();
    for (const FieldCorner& corner : loop) loops.back().push_back(place(corner));
  }
  return loops;
}

/// One triangle of the middle and an edge; an element with holes, or of one stress, is one piece of its middle's value.
struct Patch {
  std::vector<std::vector<Point>> loops;
  double value = 0;
};

bool is_of_one_stress(const FieldElement& element) {
  return std::ranges::all_of(element.loops.front(),
                             [&](const FieldCorner& corner) { return corner.stress == element.middle.stress; });
}

std::vector<Patch> patches_of(const FieldFrame& field, StressShown shown, const Place& place = as_drawn) {
  std::vector<Patch> patches;
  for (const FieldElement& element : field.elements) {
    const double middle = component(element.middle.stress, shown);
    if (element.loops.size() > 1 || is_of_one_stress(element)) {
      patches.push_back({loops_of(element, place), middle});
      continue;
    }
    const auto& loop = element.loops.front();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const FieldCorner& a = loop[i];
      const FieldCorner& b = loop[(i + 1) % loop.size()];
      const double mean = (middle + component(a.stress, shown) + component(b.stress, shown)) / 3;
      patches.push_back({{{place(element.middle), place(a), place(b)}}, mean});
    }
  }
  return patches;
}

/// From blue through white to red where values have both signs, else from pale to dark.
struct ColourScale {
  double low = 0;
  double high = 1;

  std::string colour(double value) const {
    constexpr std::array<std::array<double, 3>, 5> kStops{
        {{33, 102, 172}, {146, 197, 222}, {247, 247, 247}, {244, 165, 130}, {178, 24, 43}}};
    const double share = high > low ? std::clamp((value - low) / (high - low), 0.0, 1.0) : 0.5;
    const double at = share * (kStops.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
    const double part = at - static_cast<double>(below);
    const auto mix = [&](std::size_t channel) {
      return static_cast<int>(std::lround(std::lerp(kStops[below][channel], kStops[below + 1][channel], part)));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2));
  }
};

/// White stands for no stress where values of both signs are there.
ColourScale scale_of(const std::vector<Patch>& patches) {
  std::vector<double> values;
  for (const Patch& patch : patches) values.push_back(patch.value);
  if (values.empty()) return {};
  std::ranges::sort(values);
  const auto left_out = static_cast<std::size_t>(kExtreme * static_cast<double>(values.size()));
  ColourScale scale{values[left_out], values[values.size() - 1 - left_out]};
  if (scale.low < 0 && scale.high > 0) {
    const double most = std::max(-scale.low, scale.high);
    scale = {-most, most};
  }
  return scale;
}

double shown_factor(const FieldFrame& end, const Box& box) {
  double most = 0;
  visit_corners(end, [&](const FieldCorner& corner) { most = std::max(most, length(corner.displacement)); });
  const double extent = std::hypot(box.width(), box.height());
  if (!(most > 0) || !(extent > 0)) return 1;
  return round_down(kLargestMove * extent / most);
}

std::string elements_in_words(const FieldFrame& field) {
  const std::size_t count = field.elements.size();
  return body_count(field) == count ? counted(count, "block") : fmt::format("mesh, {} elements", count);
}

void draw_mesh(SvgPage& page, const PageMap& map, const FieldFrame& field, const Place& place, bool filled) {
  const double width = std::min(0.8, edge_width(map.size(), field.elements.size()));
  for (const FieldElement& element : field.elements)
    page.polygon(
        map(loops_of(element, place)),
        {.fill = filled ? area_colour(element.material) : "none", .stroke = kMeshColour, .stroke_width = width});
}

void draw_colour_bar(SvgPage& page, Point corner, double height, const ColourScale& scale, std::string_view name) {
  constexpr int kSteps = 48;
  for (int i = 0; i < kSteps; ++i) {
    const double share = (i + 0.5) / kSteps;
    const std::string colour = scale.colour(std::lerp(scale.high, scale.low, share));
    page.rectangle({corner.x, corner.y + height * i / kSteps}, 14, height / kSteps + 0.4, {.fill = colour});
  }
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
    page.text({corner.x + 20, corner.y + share * height + 4},
              fmt::format("{:.3g}", std::lerp(scale.high, scale.low, share)), {.size = 11});
  page.text({corner.x, corner.y - 8}, name, {.size = 12, .bold = true});
}

void draw_stress(SvgPage& page, const PageMap& map, const std::vector<Patch>& patches, const ColourScale& scale) {
  for (const Patch& patch : patches) {
    const std::string colour = scale.colour(patch.value);
    page.polygon(map(patch.loops), {.fill = colour, .stroke = colour, .stroke_width = 0.3});
  }
}

/// Where the three panels stand.
struct Panels {
  std::array<Point, 3> corners;
  Point room;
  double bottom = 0;
};

Panels place_panels(const Box& box) {
  Panels panels;
  const double top = kTitleHeight;
  const bool is_tall = box.height() > 0.9 * box.width();
  panels.room = is_tall ? Point{(kRoom - kBarWidth - 2 * kGap) / 3, 460} : Point{kRoom - kBarWidth, 300};
  const Point size = PageMap(box, {}, panels.room).size();
  for (std::size_t k = 0; k < 3; ++k) {
    const double step = static_cast<double>(k);
    panels.corners[k] = is_tall ? Point{kMargin + step * (panels.room.x + kGap), top + kCaption}
                                : Point{kMargin, top + kCaption + step * (size.y + kCaption + kGap)};
  }
  panels.bottom = panels.corners[2].y + size.y + 12;
  return panels;
}

}  // namespace

StressShown most_varied(const FieldFrame& field) {
  StressShown most = StressShown::xx;
  double widest = -1;
  for (const StressShown shown : {StressShown::xx, StressShown::yy, StressShown::xy}) {
    const ColourScale scale = scale_of(patches_of(field, shown));
    if (!(scale.high - scale.low > widest * (1 + 1e-9))) continue;
    widest = scale.high - scale.low;
    most = shown;
  }
  return most;
}

std::string field_picture(const FieldPicture& picture) {
  const double wanted = shown_factor(picture.end, bounds(picture.end, as_drawn));
  const double factor = picture.is_of_motion ? std::max(1.0, wanted) : wanted;
  const Place deformed = [factor](const FieldCorner& corner) { return corner.position + factor * corner.displacement; };
  const bool is_true = picture.is_of_motion && factor == 1;
  Box box = bounds(picture.start, as_drawn);
  visit_corners(picture.end, [&](const FieldCorner& corner) { box.include(deformed(corner)); });
  const Panels panels = place_panels(box);
  SvgPage page(kPageWidth, panels.bottom + 40);
  page.text({kMargin, 28}, picture.title, {.size = 17, .bold = true});
  if (box.empty()) return page.str();
  const auto map = [&](std::size_t k) { return PageMap(box, panels.corners[k], panels.room); };
  const auto caption = [&](std::size_t k, const std::string& words) {
    page.text(panels.corners[k] - Point{0, 8}, words, {.size = 13});
  };
  caption(0, elements_in_words(picture.start));
  draw_mesh(page, map(0), picture.start, as_drawn, true);
  caption(1, fmt::format("displacement × {:g}", factor));
  draw_mesh(page, map(1), picture.end, deformed, true);
  const std::vector<Patch> patches = patches_of(picture.end, picture.stress, is_true ? deformed : as_drawn);
  const ColourScale scale = scale_of(patches);
  const bool is_stressed = scale.low != 0 || scale.high != 0;
  caption(2, is_stressed ? fmt::format("{}, tension positive", name_of(picture.stress)) : "no stress");
  draw_stress(page, map(2), patches, scale);
  if (body_count(picture.end) == picture.end.elements.size())
    draw_mesh(page, map(2), picture.end, is_true ? deformed : as_drawn, false);
  for (const PointFrame& point : picture.measured)
    draw_mark(page, map(2)(is_true ? point.position : point.position - point.displacement), Mark::measured_point);
  const Point size = map(2).size();
  if (is_stressed)
    draw_colour_bar(page, {panels.corners[2].x + std::min(size.x, panels.room.x) + 14, panels.corners[2].y},
                    std::min(size.y, 240.0), scale, name_of(picture.stress));
  draw_scale_bar(page, {kMargin, panels.bottom + 14}, kRoom, map(0));
  return page.str();
}

std::string mesh_picture(const std::string& title, const FieldFrame& mesh) {
  const Box box = bounds(mesh, as_drawn);
  const PageMap map(box, {kMargin, kTitleHeight}, {kRoom, 640});
  SvgPage page(kPageWidth, kTitleHeight + map.size().y + 60);
  page.text({kMargin, 28}, title, {.size = 17, .bold = true});
  if (box.empty()) return page.str();
  draw_mesh(page, map, mesh, as_drawn, true);
  draw_scale_bar(page, {kMargin, kTitleHeight + map.size().y + 26}, kRoom, map);
  return page.str();
}

}  // namespace keyblock::report
