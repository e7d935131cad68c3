// Two panels in colours of a value, one in colours of states; see plastic_picture.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/rock/plastic_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "material/stress_invariants.hpp"
#include "problem/units/measure.hpp"
#include "report/drawing/field_patches.hpp"
#include "report/drawing/scene.hpp"
#include "report/page.hpp"

namespace keyblock::report {
namespace {

constexpr double kGap = 22;
constexpr double kCaption = 42;    // and the name on the colour bar
constexpr double kKeyWidth = 118;  // colour bar with its numbers, or the names of states
constexpr double kMostBar = 240;
constexpr double kSeam = 0.7;
constexpr double kLeastHeight = 114;  // all states under each other

struct State {
  std::string_view name;
  std::string_view colour;
};

// Colours of the regions in their order, then of elements that do not yield now (after Okabe and Ito).
constexpr std::array<State, 6> kStates{{{"has not yielded", "#ececec"},
                                        {"smooth part", "#e69f00"},
                                        {"edge", "#d55e00"},
                                        {"apex", "#009e73"},
                                        {"tension", "#0072b2"},
                                        {"yielded before", "#a9cfe6"}}};
constexpr std::size_t kBefore = 5;

std::size_t state_of(const FieldElement& element) {
  const PlasticState plastic = element.middle.plastic.value_or(PlasticState{});
  if (plastic.region == YieldRegion::elastic && plastic.has_yielded) return kBefore;
  return static_cast<std::size_t>(plastic.region);
}

/// Places of the panels.
struct Layout {
  std::array<Point, 3> corners;
  Point room;
  Point size;
  double bottom = 0;
};

Point room_in(std::size_t columns) {
  const auto count = static_cast<double>(columns);
  return {(kRoom - count * kKeyWidth - (count - 1) * kGap) / count, 220 + 80 * count};
}

/// Returns the number of panels per row that shows the bodies largest; more than one row costs a tenth.
std::size_t columns_of(const Box& box) {
  std::size_t best = 1;
  double largest = 0;
  for (const std::size_t columns : {3, 2, 1}) {
    const double scale = PageMap(box, {}, room_in(columns)).scale() * (columns == 1 ? 0.9 : 1);
    if (scale <= largest) continue;
    largest = scale;
    best = columns;
  }
  return best;
}

Layout layout_of(const Box& box) {
  Layout layout;
  const std::size_t columns = columns_of(box);
  layout.room = room_in(columns);
  layout.size = PageMap(box, {}, layout.room).size();
  const double height = std::max(layout.size.y, kLeastHeight);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto column = static_cast<double>(k % columns), row = static_cast<double>(k / columns);
    layout.corners[k] = {kMargin + column * (layout.room.x + kKeyWidth + kGap),
                         kTitleHeight + kCaption + row * (height + kCaption + kGap)};
  }
  layout.bottom = layout.corners[2].y + height;
  return layout;
}

void draw_outlines(SvgPage& page, const PageMap& map, const PlasticPicture& picture) {
  const Style edge{.stroke = "#333333", .stroke_width = edge_width(map.size(), body_count(picture.end))};
  std::vector<int> elements(body_count(picture.end));
  for (const FieldElement& element : picture.end.elements) ++elements[static_cast<std::size_t>(element.body)];
  page.layer([&] {
    for (const std::vector<Point>& outline : picture.outlines) page.polygon({map(outline)}, edge);
    for (const FieldElement& element : picture.end.elements)
      if (elements[static_cast<std::size_t>(element.body)] == 1) page.polygon(map(loops_of(element, as_moved)), edge);
  });
}

double greatest_equivalent(const FieldFrame& field) {
  double most = 0;
  visit_corners(field, [&](const FieldCorner& corner) {
    most = std::max(most, corner.plastic.value_or(PlasticState{}).equivalent);
  });
  return most;
}

void draw_states(SvgPage& page, const PageMap& map, const FieldFrame& field, Point key) {
  std::set<std::size_t> met;
  page.layer([&] {
    for (const FieldElement& element : field.elements) {
      const std::size_t state = state_of(element);
      met.insert(state);
      const std::string_view colour = kStates[state].colour;
      page.polygon(map(loops_of(element, as_moved)), {.fill = colour, .stroke = colour, .stroke_width = kSeam});
    }
  });
  double y = key.y;
  for (const std::size_t state : met) {
    page.rectangle({key.x, y}, 14, 14, {.fill = kStates[state].colour, .stroke = "#888888", .stroke_width = 0.5});
    page.text({key.x + 20, y + 11}, kStates[state].name, {.size = 11});
    y += 19;
  }
}

}  // namespace

std::string plastic_picture(const PlasticPicture& picture) {
  const Box box = bounds(picture.end, as_moved);
  const Layout layout = layout_of(box);
  SvgPage page(kPageWidth, layout.bottom + 46);
  page.text({kMargin, 28}, picture.title, {.size = 17, .bold = true});
  if (box.empty()) return page.str();
  const auto map = [&](std::size_t k) { return PageMap(box, layout.corners[k], layout.room); };
  const auto key = [&](std::size_t k) {
    return layout.corners[k] + Point{std::min(layout.size.x, layout.room.x) + 14, 0};
  };
  const auto draw_caption = [&](std::size_t k, const std::string& words) {
    page.text(layout.corners[k] - Point{0, 26}, words, {.size = 13});  // above the name on the bar
  };
  const auto draw = [&](std::size_t k, const std::string& caption, const Described& quantity, ColourScale::Map colours,
                        const CornerValue& value) {
    draw_caption(k, caption);
    const std::vector<Patch> patches = patches_of(picture.end, value, as_moved);
    const ColourScale scale = scale_of(patches, colours);
    draw_patches(page, map(k), patches, scale, kSeam);
    draw_outlines(page, map(k), picture);
    if (scale.high > scale.low) draw_colour_bar(page, key(k), std::min(layout.size.y, kMostBar), scale, quantity);
  };
  draw(0, fmt::format("equivalent plastic strain, up to {:.3g}", greatest_equivalent(picture.end)), "κ [–]",
       ColourScale::Map::rising,
       [](const FieldCorner& corner) { return corner.plastic.value_or(PlasticState{}).equivalent; });
  draw(1, "mean stress, tension positive", {"σm", measures::kStress, picture.units}, ColourScale::Map::about_zero,
       [](const FieldCorner& corner) { return invariants_of(corner.stress).mean; });
  draw_caption(2, "state of the rock");
  draw_states(page, map(2), picture.end, key(2));
  draw_outlines(page, map(2), picture);
  draw_scale_bar(page, {kMargin, layout.bottom + 22}, kRoom, map(0), picture.units);
  return page.str();
}

}  // namespace keyblock::report
