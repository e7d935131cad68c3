// Panels of one size under one title; see field_picture.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/field_picture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "base/counted.hpp"
#include "material/stress_invariants.hpp"
#include "problem/units/measure.hpp"
#include "report/drawing/colours.hpp"
#include "report/drawing/field_patches.hpp"
#include "report/drawing/scene.hpp"
#include "report/drawing/stress_crosses.hpp"
#include "report/drawing/svg.hpp"
#include "report/drawing/ticks.hpp"
#include "report/field_panels.hpp"
#include "report/page.hpp"
#include "result/extremes.hpp"

namespace keyblock::report {
namespace {

constexpr double kLargestMove = 0.08;  // of the extent, in the deformed mesh
constexpr double kBarHeight = 240;
constexpr double kUsualCaption = 13;
constexpr double kNarrowCaption = 12;
constexpr double kNote = 20;          // height of a line of notes in a narrow picture
constexpr double kNoteBaseline = 10;  // below its upper edge
constexpr std::string_view kMeshColour = "#333333";
constexpr std::string_view kPaleMeshColour = "#dddddd";
constexpr std::string_view kContourColour = "#555555";
constexpr double kContourWidth = 0.5;
constexpr int kContours = 8;

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
    case FieldShown::crosses:
      return 0;  // no value but two
  }
  return 0;
}

std::string_view name_of(FieldShown shown) {
  constexpr std::array<std::string_view, 8> kNames{
      "σxx", "σyy", "σxy", "σ1", "σ3", "von Mises stress", "displacement", "principal stresses"};
  return kNames[static_cast<std::size_t>(shown)];
}

bool is_displacement(FieldShown shown) {
  return shown == FieldShown::displacement;
}

// Never below zero.
bool is_amount(FieldShown shown) {
  return shown == FieldShown::von_mises || is_displacement(shown);
}

ColourScale::Map map_of(FieldShown shown) {
  return is_amount(shown) ? ColourScale::Map::rising : ColourScale::Map::about_zero;
}

std::string caption_of(FieldShown shown, bool is_there) {
  if (!is_there) return is_displacement(shown) ? "no displacement" : "no stress";
  const std::string_view name = name_of(shown);
  if (shown == FieldShown::greatest) return fmt::format("{}, the greatest, tension positive", name);
  if (shown == FieldShown::least) return fmt::format("{}, the least, tension positive", name);
  if (shown == FieldShown::von_mises) return "von Mises stress";
  return is_displacement(shown) ? std::string(name) : fmt::format("{}, tension positive", name);
}

std::vector<Patch> shown_patches(const FieldFrame& field, FieldShown shown, const CornerPlace& place = as_drawn) {
  return patches_of(
      field, [shown](const FieldCorner& corner) { return value_of(corner, shown); }, place);
}

double greatest_move(const FieldFrame& field) {
  double most = 0;
  visit_corners(field, [&](const FieldCorner& corner) { most = std::max(most, length(corner.displacement)); });
  return most;
}

double shown_factor(double most, const Box& box, bool is_of_motion) {
  const double extent = std::hypot(box.width(), box.height());
  if (!(most > 0) || !(extent > 0)) return 1;
  const double wanted = round_down(kLargestMove * extent / most);
  return is_of_motion ? std::max(1.0, wanted) : wanted;
}

bool are_blocks(const FieldFrame& field) {
  return body_count(field) == field.elements.size();
}

std::string elements_in_words(const FieldFrame& field) {
  const std::size_t count = field.elements.size();
  return are_blocks(field) ? counted(count, "block") : fmt::format("mesh, {} elements", count);
}

void draw_mesh(SvgPage& page, const PageMap& map, const FieldFrame& field, const CornerPlace& place, bool filled,
               std::string_view colour = kMeshColour) {
  const double width = std::min(0.8, edge_width(map.size(), field.elements.size()));
  page.layer([&] {
    for (const FieldElement& element : field.elements)
      page.polygon(map(loops_of(element, place)),
                   {.fill = filled ? area_colour(element.material) : "none", .stroke = colour, .stroke_width = width});
  });
}

/// Returns the picture without the elements that pictures of the run leave out.
FieldPicture framed(const FieldPicture& whole) {
  FieldPicture picture = whole;
  const std::vector<std::size_t>& left_out = whole.left_out;
  picture.end.elements = without(whole.end.elements, left_out);
  if (!whole.numbers.empty()) picture.numbers = without(whole.numbers, left_out);
  picture.held.clear();
  for (const std::size_t held : whole.held) {
    const auto at = std::ranges::lower_bound(left_out, held);
    if (at == left_out.end() || *at != held)
      picture.held.push_back(held - static_cast<std::size_t>(at - left_out.begin()));
  }
  return picture;
}

bool is_without_stress(const FieldElement& element) {
  const auto is_zero = [](const FieldCorner& corner) { return corner.stress == Stress{}; };
  return is_zero(element.middle) && std::ranges::all_of(element.loops, [&](const std::vector<FieldCorner>& loop) {
           return std::ranges::all_of(loop, is_zero);
         });
}

/// Fixed blocks without stress and, if there are any, the other elements.
struct Held {
  FieldFrame held;
  std::optional<FieldFrame> others;
};

Held held_of(const FieldPicture& picture) {
  Held found;
  if (is_displacement(picture.shown)) return found;
  const std::vector<FieldElement>& elements = picture.end.elements;
  std::vector<std::size_t> held;
  for (const std::size_t i : picture.held)
    if (i < elements.size() && is_without_stress(elements[i])) held.push_back(i);
  if (held.empty()) return found;
  std::ranges::sort(held);
  held.erase(std::ranges::unique(held).begin(), held.end());  // a block may have several fixed points
  for (const std::size_t i : held) found.held.elements.push_back(elements[i]);
  found.others.emplace().elements = without(elements, held);
  return found;
}

void draw_held(SvgPage& page, const PageMap& map, const FieldFrame& held, const CornerPlace& place) {
  page.layer([&] {
    for (const FieldElement& element : held.elements)
      page.polygon(map(loops_of(element, place)), {.fill = kHeldColour});
  });
}

/// Beside the scale bar.
void draw_key(SvgPage& page, Point corner, const FieldFrame& held) {
  if (held.elements.empty()) return;
  draw_legend(page, corner, kRoom / 2,
              {{.sign = LegendEntry::Sign::area, .colour = kHeldColour, .words = "fixed, stress not computed"}});
}

/// Writes the numbers of elements; returns the words of the caption about elements too small for theirs.
std::string number_elements(SvgPage& page, const PageMap& map, const FieldFrame& field, const std::vector<int>& numbers,
                            const CornerPlace& place) {
  std::vector<NumberedBlock> numbered;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbered.push_back({numbers[i], map(loops_of(field.elements[i], place))});
  return without_number_in_words(draw_block_numbers(page, numbered));
}

/// The panel of the field.
struct FieldPanel {
  const PageMap& map;
  const CornerPlace& place;
  bool has_edges = false;  ///< those of blocks, over their colours
  Point key;               ///< of colours, or lengths: its upper left corner
  double key_height = 0;
};

/// The colour scale of patches: that of all pictures of the run if they share one.
ColourScale colours_of(const FieldPicture& picture, const std::vector<Patch>& patches) {
  return picture.scale ? with_ends(picture.scale->colours, patches) : scale_of(patches, map_of(picture.shown));
}

void draw_contours(SvgPage& page, const FieldPanel& panel, const FieldPicture& picture, const FieldFrame& field,
                   const ColourScale& scale) {
  const auto value = [&](const FieldCorner& corner) { return value_of(corner, picture.shown); };
  for (const ContourLine& line :
       contours_of(field, value, panel.place, make_axis(scale.low, scale.high, kContours).ticks))
    page.line(panel.map(line[0]), panel.map(line[1]), {.stroke = kContourColour, .stroke_width = kContourWidth});
}

/// Draws crosses over a pale mesh, or below the edges of blocks. Returns the name of the panel.
std::string draw_stress_crosses(SvgPage& page, const FieldPanel& panel, const FieldPicture& picture,
                                const FieldFrame& field) {
  if (!panel.has_edges) draw_mesh(page, panel.map, picture.end, panel.place, false, kPaleMeshColour);
  const double most = picture.scale ? picture.scale->most_stress : 0;
  const CrossScale scale = draw_crosses(page, panel.map, field, panel.place, most);
  if (panel.has_edges) draw_mesh(page, panel.map, picture.end, panel.place, false);
  if (scale.sample == 0) return "no stress";
  draw_cross_legend(page, panel.key, scale, picture.units);
  return "principal stresses in the plane";
}

/// Draws fixed blocks, the field, and edges of blocks over them. Returns the name of the panel.
std::string draw_field(SvgPage& page, const FieldPanel& panel, const FieldPicture& picture, const Held& held) {
  const FieldFrame& field = held.others ? *held.others : picture.end;
  if (picture.shown == FieldShown::crosses) {
    draw_held(page, panel.map, held.held, panel.place);
    return draw_stress_crosses(page, panel, picture, field);
  }
  const std::vector<Patch> patches = shown_patches(field, picture.shown, panel.place);
  const ColourScale scale = colours_of(picture, patches);
  const bool is_there = scale.low != 0 || scale.high != 0;
  page.layer([&] {
    draw_held(page, panel.map, held.held, panel.place);
    draw_patches(page, panel.map, patches, scale);
    if (is_there) draw_contours(page, panel, picture, field, scale);
    if (panel.has_edges) draw_mesh(page, panel.map, picture.end, panel.place, false);
  });
  if (!is_there) return caption_of(picture.shown, false);
  draw_colour_bar(
      page, panel.key, panel.key_height, scale,
      {name_of(picture.shown), is_displacement(picture.shown) ? measures::kLength : measures::kStress, picture.units});
  return caption_of(picture.shown, true);
}

using Caption = std::function<void(std::size_t, const std::string&)>;

/// Draws the mesh as it was and deformed, each with its caption and the numbers of its elements.
void draw_meshes(SvgPage& page, const std::array<PageMap, 2>& maps, const FieldPicture& picture,
                 const FieldPicture& whole, const CornerPlace& deformed, double factor, const Caption& caption) {
  const FieldFrame& start = picture.start.elements.empty() ? whole.end : picture.start;
  const std::size_t left_out = picture.left_out.size();
  draw_mesh(page, maps[0], start, as_drawn, true);
  caption(0, elements_in_words(start) + number_elements(page, maps[0], start, whole.numbers, as_drawn));
  draw_mesh(page, maps[1], picture.end, deformed, true);
  number_elements(page, maps[1], picture.end, picture.numbers, deformed);
  caption(1, fmt::format("displacement × {:g}{}", factor, left_out > 0 ? "; " + outside_in_words(left_out) : ""));
}

/// Writes what a narrow picture, which has no captions of meshes, says of its elements: one line each for those that
/// are left out and, if they have numbers, for those too small for theirs.
void write_notes(SvgPage& page, const PageMap& map, const FieldPicture& picture, const CornerPlace& place, double top) {
  std::vector<std::string> notes;
  if (!picture.left_out.empty()) notes.push_back(outside_in_words(picture.left_out.size()));
  if (!picture.numbers.empty())
    notes.push_back(elements_in_words(picture.end) + number_elements(page, map, picture.end, picture.numbers, place));
  const double room = picture.wide - 2 * kMargin;
  for (const std::string& note : notes) {
    const double size = std::min(1.0, room / text_width(note, kNarrowCaption)) * kNarrowCaption;
    page.text({kMargin, top + kNoteBaseline}, note, {.size = size});
    top += kNote;
  }
}

double height_of_notes(const FieldPicture& picture) {
  return kNote * ((picture.left_out.empty() ? 0 : 1) + (picture.numbers.empty() ? 0 : 1));
}

/// Draws the measured points that lie in the box.
void draw_measured(SvgPage& page, const PageMap& map, const FieldPicture& picture, const Box& box, bool is_true) {
  page.layer([&] {
    for (const PointFrame& point : picture.measured) {
      const Point at = is_true ? point.position : point.position - point.displacement;
      const bool is_shown = at.x >= box.low.x && at.x <= box.high.x && at.y >= box.low.y && at.y <= box.high.y;
      if (is_shown) draw_mark(page, map(at), Mark::measured_point);
    }
  });
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
    const double width = range_of(shown_patches(field, shown));
    if (!(width > widest * (1 + 1e-9))) continue;
    widest = width;
    most = shown;
  }
  return most;
}

FieldScale common_scale(const FieldFrame& start, FieldShown shown, bool is_of_motion, const EachFrame& each) {
  FieldScale scale;
  double most_move = 0;
  scale.box = bounds(start, as_drawn);
  std::optional<ColourScale> colours;
  each([&](const FieldFrame& field) {
    most_move = std::max(most_move, greatest_move(field));
    if (shown == FieldShown::crosses) {
      scale.most_stress = std::max(scale.most_stress, common_stress(field));
      return;
    }
    const ColourScale own = scale_of(shown_patches(field, shown), map_of(shown));
    colours = colours ? covering(*colours, own) : own;
  });
  if (colours) scale.colours = *colours;
  scale.factor = shown_factor(most_move, scale.box, is_of_motion);
  each([&](const FieldFrame& field) {
    visit_corners(field, [&](const FieldCorner& c) { scale.box.include(c.position + scale.factor * c.displacement); });
  });
  return scale;
}

std::string field_picture(const FieldPicture& whole) {
  std::optional<FieldPicture> own;
  const FieldPicture& picture = whole.left_out.empty() ? whole : own.emplace(framed(whole));
  const FieldFrame& start = picture.start.elements.empty() ? whole.end : picture.start;
  const Held held = held_of(picture);
  const double factor =
      picture.scale ? picture.scale->factor
                    : shown_factor(greatest_move(picture.end), bounds(picture.end, as_drawn), picture.is_of_motion);
  const CornerPlace deformed = [factor](const FieldCorner& corner) {
    return corner.position + factor * corner.displacement;
  };
  const bool is_true = picture.is_of_motion && factor == 1, is_alone = picture.wide < kLeastForThree;
  const CornerPlace place = is_true ? deformed : as_drawn;
  Box box = picture.scale ? picture.scale->box : bounds(start, as_drawn);
  visit_corners(picture.end, [&](const FieldCorner& corner) { box.include(deformed(corner)); });
  const double room = picture.wide - 2 * kMargin;
  const PageTitle title = title_of(picture.title, room, is_alone);
  const Panels panels = place_panels(box, picture.wide, title.bottom);
  const double foot = panels.bottom + (is_alone && !held.held.elements.empty() ? 64 : 40);
  SvgPage page(picture.wide, foot + (is_alone ? height_of_notes(picture) : 0));
  draw_title(page, title);
  if (box.empty()) return page.str();
  const auto map = [&](std::size_t k) { return PageMap(box, panels.corners[k], panels.rooms[k]); };
  const auto caption = [&](std::size_t k, const std::string& words) {
    const double size = is_alone ? kNarrowCaption : kUsualCaption;
    const double wide = is_alone ? room : panels.rooms[k].x;
    page.text(panels.corners[k] - Point{0, 8}, words, {.size = std::min(1.0, wide / text_width(words, size)) * size});
  };
  if (!is_alone) draw_meshes(page, {map(0), map(1)}, picture, whole, deformed, factor, caption);
  const PageMap large = map(2);
  const Point size = large.size();
  const Point beside{panels.corners[2].x + std::min(size.x, panels.rooms[2].x) + 14, panels.corners[2].y};
  caption(2,
          draw_field(page, {large, place, are_blocks(whole.end), beside, std::min(size.y, kBarHeight)}, picture, held));
  draw_measured(page, large, picture, box, is_true);
  if (is_alone) write_notes(page, large, picture, place, foot);
  draw_scale_bar(page, {kMargin, panels.bottom + 14}, room, large, picture.units);
  draw_key(page, is_alone ? Point{kMargin, panels.bottom + 28} : Point{kMargin + room / 2, panels.bottom + 4},
           held.held);
  return page.str();
}

std::string mesh_picture(const std::string& title, const FieldFrame& mesh, const Units& units, Numbers numbers) {
  const Box box = bounds(mesh, as_drawn);
  const PageMap map(box, {kMargin, kTitleHeight}, {kRoom, 640});
  SvgPage page(kPageWidth, kTitleHeight + map.size().y + 60);
  std::vector<int> all(numbers == Numbers::all ? mesh.elements.size() : 0);
  std::iota(all.begin(), all.end(), 1);
  if (!box.empty()) draw_mesh(page, map, mesh, as_drawn, true);
  page.text({kMargin, 28}, title + number_elements(page, map, mesh, all, as_drawn), {.size = 17, .bold = true});
  if (box.empty()) return page.str();
  draw_scale_bar(page, {kMargin, kTitleHeight + map.size().y + 26}, kRoom, map, units);
  return page.str();
}

}  // namespace keyblock::report
