// Triangles about the middles of elements, and colours between stops; see field_patches.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/field_patches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "geometry/polygon.hpp"
#include "report/drawing/colours.hpp"
#include "report/drawing/ticks.hpp"

namespace keyblock::report {
namespace {

constexpr double kUnseen = 1e-4;    // of the largest number beside a bar of colours: a smaller one is written as 0
constexpr double kRoundOff = 1e-9;  // of the range of a scale: what is beyond it by less is not
constexpr double kExtreme = 0.005;  // share of patches, or of their area, beyond either end of the colours

// Share of the value farthest from 0: if the nearest value exceeds it, 0 is not on the scale.
constexpr double kNearShare = 0.5;
constexpr double kBarRoom = 104;  // page units from a colour bar to the edge of the page
constexpr double kPalest = 0.08;  // of all colours: from white to the palest of a scale without 0

bool is_uniform(const FieldElement& element) {
  return std::ranges::all_of(element.loops.front(), [&](const FieldCorner& corner) {
    return corner.stress == element.middle.stress && corner.plastic == element.middle.plastic;
  });
}

bool is_one_piece(const FieldElement& element) {
  return element.loops.size() > 1 || is_uniform(element);
}

using Triangle = std::array<std::pair<Point, double>, 3>;

/// Returns the line of value `level` over a triangle, from edge to edge. One corner lies below the level, one does not.
ContourLine contour_in(const Triangle& corners, double level) {
  ContourLine ends;
  std::size_t found = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [a, low] = corners[i];
    const auto& [b, high] = corners[(i + 1) % 3];
    if (found < 2 && (low < level) != (high < level)) ends[found++] = a + (level - low) / (high - low) * (b - a);
  }
  return ends;
}

/// Adds the lines of ascending `levels` over a triangle.
void add_contours(std::vector<ContourLine>& lines, const Triangle& corners, const std::vector<double>& levels) {
  const auto [least, most] = std::minmax({corners[0].second, corners[1].second, corners[2].second});
  for (auto level = std::ranges::upper_bound(levels, least); level != levels.end() && *level <= most; ++level)
    lines.push_back(contour_in(corners, *level));
}

/// The first of `values` in the order of `less` by which their areas sum to `share`.
template <class Less>
double value_at(std::vector<std::pair<double, double>>& values, double share, Less less) {
  // The end is enough in most fields: sorting all takes ten times as long.
  for (std::size_t count = values.size() / 32 + 1;; count = values.size()) {
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(values.begin(), end, values.end(), less);
    auto value = values.begin();
    for (double sum = value->second; sum < share && ++value != end;) sum += value->second;
    if (value != end) return value->first;
    if (count == values.size()) return values.back().first;
  }
}

/// Returns the ends of the values of all patches, except those of an extreme share of the area at either end.
std::pair<double, double> ends_by_area(const std::vector<Patch>& patches) {
  std::vector<std::pair<double, double>> values;  // with areas
  double whole = 0;
  for (const Patch& patch : patches) {
    double sum = 0;
    for (const std::vector<Point>& loop : patch.loops) sum += area(loop);  // of holes below 0
    values.emplace_back(patch.value, std::abs(sum));
    whole += std::abs(sum);
  }
  const double low = value_at(values, kExtreme * whole, std::less<>());
  return {low, value_at(values, kExtreme * whole, std::greater<>())};
}

}  // namespace

Box bounds(const FieldFrame& field, const CornerPlace& place) {
  Box box;
  visit_corners(field, [&](const FieldCorner& corner) { box.include(place(corner)); });
  return box;
}

std::vector<std::vector<Point>> loops_of(const FieldElement& element, const CornerPlace& place) {
  std::vector<std::vector<Point>> loops;
  for (const auto& loop : element.loops) {
    loops.emplace_back();
    for (const FieldCorner& corner : loop) loops.back().push_back(place(corner));
  }
  return loops;
}

std::vector<Patch> patches_of(const FieldFrame& field, const CornerValue& value, const CornerPlace& place) {
  std::vector<Patch> patches;
  patches.reserve(field.elements.size());
  const bool are_many = field.elements.size() > kMostSplit;
  for (const FieldElement& element : field.elements) {
    const double middle = value(element.middle);
    if (are_many || is_one_piece(element)) {
      patches.emplace_back(loops_of(element, place), middle);
      continue;
    }
    const auto& loop = element.loops.front();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const FieldCorner& a = loop[i];
      const FieldCorner& b = loop[(i + 1) % loop.size()];
      Patch& patch = patches.emplace_back(std::vector<std::vector<Point>>(1), (middle + value(a) + value(b)) / 3);
      patch.loops[0] = {place(element.middle), place(a), place(b)};
    }
  }
  return patches;
}

std::vector<ContourLine> contours_of(const FieldFrame& field, const CornerValue& value, const CornerPlace& place,
                                     const std::vector<double>& levels) {
  std::vector<ContourLine> lines;
  std::vector<std::pair<Point, double>> corners;
  for (const FieldElement& element : field.elements) {
    if (is_one_piece(element)) continue;
    const auto with_value = [&](const FieldCorner& corner) { return std::pair{place(corner), value(corner)}; };
    corners.clear();
    std::ranges::transform(element.loops.front(), std::back_inserter(corners), with_value);
    const auto middle = with_value(element.middle);
    for (std::size_t i = 0; i < corners.size(); ++i)
      add_contours(lines, {middle, corners[i], corners[(i + 1) % corners.size()]}, levels);
  }
  return lines;
}

namespace {

double share_of(double value, double from, double to, double otherwise) {
  return to > from ? std::clamp((value - from) / (to - from), 0.0, 1.0) : otherwise;
}

/// Returns the place of a value in the colours from blue (0) through white to red (1).
double share_about_zero(const ColourScale& scale, double value) {
  if (scale.high < 0) return std::lerp(0.0, 0.5 - kPalest, share_of(value, scale.low, scale.high, 0));
  if (scale.low > 0) return std::lerp(0.5 + kPalest, 1.0, share_of(value, scale.low, scale.high, 1));
  const double most = std::max(-scale.low, scale.high);
  return share_of(value, -most, most, 0.5);
}

}  // namespace

std::string ColourScale::colour(double value) const {
  return map == Map::rising ? hex(colour_at(palette::kRising, share_of(value, low, high, 0)))
                            : hex(colour_at(palette::kAboutZero, share_about_zero(*this, value)));
}

namespace {

ColourScale ends_of(const std::vector<Patch>& patches, ColourScale::Map map) {
  if (map == ColourScale::Map::rising) {
    std::vector<Patch> risen;
    std::ranges::copy_if(patches, std::back_inserter(risen), [](const Patch& patch) { return patch.value > 0; });
    return {0, risen.empty() ? 0 : ends_by_area(risen).second, map};
  }
  const auto [low, high] = ends_by_area(patches);
  if (high < kNearShare * low) return {low, high, map};
  if (low > kNearShare * high) return {low, high, map};
  return {std::min(low, 0.0), std::max(high, 0.0), map};
}

}  // namespace

ColourScale scale_of(const std::vector<Patch>& patches, ColourScale::Map map) {
  if (patches.empty()) return {};
  return with_ends(ends_of(patches, map), patches);
}

ColourScale covering(const ColourScale& one, const ColourScale& other) {
  ColourScale both = one;
  both.low = std::min(one.low, other.low);
  both.high = std::max(one.high, other.high);
  return both;
}

ColourScale with_ends(ColourScale scale, const std::vector<Patch>& patches) {
  if (patches.empty()) return scale;
  const double round_off = kRoundOff * (scale.high - scale.low);
  const auto [least, most] = std::ranges::minmax(patches, {}, &Patch::value);
  scale.has_below = least.value < scale.low - round_off;
  scale.has_above = most.value > scale.high + round_off;
  return scale;
}

double range_of(const std::vector<Patch>& patches) {
  if (patches.empty()) return 0;
  const auto [low, high] = ends_by_area(patches);
  return high - low;
}

void draw_patches(SvgPage& page, const PageMap& map, const std::vector<Patch>& patches, const ColourScale& scale,
                  double seam) {
  page.layer([&] {
    for (const Patch& patch : patches) {
      const std::string colour = scale.colour(patch.value);
      page.polygon(map(patch.loops), {.fill = colour, .stroke = colour, .stroke_width = seam});
    }
  });
}

void draw_colour_bar(SvgPage& page, Point corner, double height, const ColourScale& scale, const Described& quantity) {
  constexpr int kSteps = 48;
  const Scaled shown = readable(quantity, std::max(std::abs(scale.low), std::abs(scale.high)));
  for (int i = 0; i < kSteps; ++i) {
    const double share = (i + 0.5) / kSteps;
    const std::string colour = scale.colour(std::lerp(scale.high, scale.low, share));
    page.rectangle({corner.x, corner.y + height * i / kSteps}, 14, height / kSteps + 0.4, {.fill = colour});
  }
  const int exponent = make_axis(shown.factor * scale.low, shown.factor * scale.high, 4).exponent;
  const double least_shown = kUnseen * std::max(std::abs(scale.low), std::abs(scale.high));
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const std::string_view beyond = share == 0 && scale.has_above ? "≥ " : share == 1 && scale.has_below ? "≤ " : "";
    const double value = std::lerp(scale.high, scale.low, share);
    page.text({corner.x + 20, corner.y + share * height + 4},
              fmt::format("{}{:.3g}", beyond,
                          std::abs(value) > least_shown ? value * shown.factor / std::pow(10, exponent) : 0),
              {.size = 11});
  }
  const std::string label = with_exponent(shown.label(quantity.name), exponent);
  const bool is_long = text_width(label, 12) > kBarRoom;  // it ends where the page does
  page.text({corner.x + (is_long ? kBarRoom : 0), corner.y - 8}, label,
            {.size = 12, .anchor = is_long ? Anchor::end : Anchor::start, .bold = true});
}

}  // namespace keyblock::report
