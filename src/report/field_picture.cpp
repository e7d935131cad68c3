// Panels of one size under one title; see field_picture.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/field_picture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "base/counted.hpp"
#include "material/stress_invariants.hpp"
#include "problem/units/measure.hpp"
#include "report/drawing/colours.hpp"
#include "report/drawing/field_patches.hpp"
#include "report/drawing/scene.hpp"
#include "report/drawing/svg.hpp"
#include "report/drawing/ticks.hpp"
#include "report/page.hpp"
#include "result/extremes.hpp"

namespace keyblock::report {
namespace {

constexpr double kGap = 18;
constexpr double kCaption = 24;
constexpr double kBarWidth = 92;       // colour bar with its numbers
constexpr double kLargestMove = 0.08;  // of the extent, in the deformed mesh
constexpr std::string_view kMeshColour = "#333333";

double value_of(const FieldCorner& corner, FieldShown shown) {
  const Stress& stress = corner.stress;
  switch (shown) {
    case FieldShown::xx:
      return stress.xx;
    case FieldShown::yy:
      return stress.yy;
    case FieldShown::xy:
      return stress.xy;
    case FieldShown::greatest:
      return principal(stress).second;
    case FieldShown::least:
      return principal(stress).first;
    case FieldShown::von_mises:
      return invariants_of(stress).von_mises;
    case FieldShown::displacement:
      return length(corner.displacement);
  }
  return 0;
}

std::string_view name_of(FieldShown shown) {
  constexpr std::array<std::string_view, 7> kNames{"σxx", "σyy", "σxy", "σ1", "σ3", "von Mises stress", "displacement"};
  return kNames[static_cast<std::size_t>(shown)];
}

bool is_displacement(FieldShown shown) {
  return shown == FieldShown::displacement;
}

// Never below zero.
bool is_amount(FieldShown shown) {
  return shown == FieldShown::von_mises || is_displacement(shown);
}

// A principal stress is of one sign in most rock: white is then none, not the middle.
ColourScale::Map map_of(FieldShown shown) {
  if (is_amount(shown)) return ColourScale::Map::rising;
  const bool is_principal = shown == FieldShown::greatest || shown == FieldShown::least;
  return is_principal ? ColourScale::Map::about_zero : ColourScale::Map::diverging;
}

std::string caption_of(FieldShown shown, bool is_there) {
  if (!is_there) return is_displacement(shown) ? "no displacement" : "no stress";
  const std::string_view name = name_of(shown);
  if (shown == FieldShown::greatest)
    return fmt::format("{}, greatest principal stress in the plane, tension positive", name);
  if (shown == FieldShown::least) return fmt::format("{}, least principal stress in the plane, tension positive", name);
  if (shown == FieldShown::von_mises) return "von Mises stress";
  return is_displacement(shown) ? std::string(name) : fmt::format("{}, tension positive", name);
}

std::vector<Patch> shown_patches(const FieldFrame& field, FieldShown shown, const CornerPlace& place = as_drawn) {
  return patches_of(
      field, [shown](const FieldCorner& corner) { return value_of(corner, shown); }, place);
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

void draw_mesh(SvgPage& page, const PageMap& map, const FieldFrame& field, const CornerPlace& place, bool filled) {
  const double width = std::min(0.8, edge_width(map.size(), field.elements.size()));
  for (const FieldElement& element : field.elements)
    page.polygon(
        map(loops_of(element, place)),
        {.fill = filled ? area_colour(element.material) : "none", .stroke = kMeshColour, .stroke_width = width});
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

/// Without what the pictures of the run leave out.
FieldPicture framed(FieldPicture picture) {
  std::vector<FieldElement>& elements = picture.end.elements;
  for (auto i = picture.left_out.rbegin(); i != picture.left_out.rend(); ++i)
    elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(*i));
  return picture;
}

}  // namespace

FieldShown field_of_word(const std::string& word) {
  const auto found = std::ranges::find(kFieldWords, word);
  if (found == kFieldWords.end())
    throw std::invalid_argument(fmt::format("there is no field \"{}\", only {}", word, fmt::join(kFieldWords, ", ")));
  return static_cast<FieldShown>(found - kFieldWords.begin());
}

FieldShown most_varied(const FieldFrame& field) {
  FieldShown most = FieldShown::xx;
  double widest = -1;
  for (const FieldShown shown : {FieldShown::xx, FieldShown::yy, FieldShown::xy}) {
    const ColourScale scale = scale_of(shown_patches(field, shown));
    if (!(scale.high - scale.low > widest * (1 + 1e-9))) continue;
    widest = scale.high - scale.low;
    most = shown;
  }
  return most;
}

std::string field_picture(const FieldPicture& whole) {
  const FieldPicture picture = framed(whole);
  const std::size_t left_out = picture.left_out.size();
  const double wanted = shown_factor(picture.end, bounds(picture.end, as_drawn));
  const double factor = picture.is_of_motion ? std::max(1.0, wanted) : wanted;
  const CornerPlace deformed = [factor](const FieldCorner& corner) {
    return corner.position + factor * corner.displacement;
  };
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
  caption(1, fmt::format("displacement × {:g}{}", factor, left_out > 0 ? "; " + outside_in_words(left_out) : ""));
  draw_mesh(page, map(1), picture.end, deformed, true);
  const std::vector<Patch> patches = shown_patches(picture.end, picture.shown, is_true ? deformed : as_drawn);
  const ColourScale scale = scale_of(patches, map_of(picture.shown));
  const bool is_there = scale.low != 0 || scale.high != 0;
  caption(2, caption_of(picture.shown, is_there));
  draw_patches(page, map(2), patches, scale);
  if (body_count(whole.end) == whole.end.elements.size())
    draw_mesh(page, map(2), picture.end, is_true ? deformed : as_drawn, false);
  for (const PointFrame& point : picture.measured) {
    const Point at = is_true ? point.position : point.position - point.displacement;
    const bool is_shown = at.x >= box.low.x && at.x <= box.high.x && at.y >= box.low.y && at.y <= box.high.y;
    if (is_shown) draw_mark(page, map(2)(at), Mark::measured_point);
  }
  const Point size = map(2).size();
  if (is_there)
    draw_colour_bar(page, {panels.corners[2].x + std::min(size.x, panels.room.x) + 14, panels.corners[2].y},
                    std::min(size.y, 240.0), scale,
                    with_unit(name_of(picture.shown),
                              is_displacement(picture.shown) ? measures::kLength : measures::kStress, picture.units));
  draw_scale_bar(page, {kMargin, panels.bottom + 14}, kRoom, map(0), picture.units);
  return page.str();
}

std::string mesh_picture(const std::string& title, const FieldFrame& mesh, const Units& units) {
  const Box box = bounds(mesh, as_drawn);
  const PageMap map(box, {kMargin, kTitleHeight}, {kRoom, 640});
  SvgPage page(kPageWidth, kTitleHeight + map.size().y + 60);
  page.text({kMargin, 28}, title, {.size = 17, .bold = true});
  if (box.empty()) return page.str();
  draw_mesh(page, map, mesh, as_drawn, true);
  draw_scale_bar(page, {kMargin, kTitleHeight + map.size().y + 26}, kRoom, map, units);
  return page.str();
}

}  // namespace keyblock::report
