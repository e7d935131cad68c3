// Lays out scene and chart on one page.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/run_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "report/drawing/colours.hpp"
#include "report/drawing/scene.hpp"
#include "report/page.hpp"

namespace keyblock::report {
namespace {

constexpr double kScaleBarHeight = 26;
constexpr std::string_view kStartColour = "#b03060";
constexpr std::string_view kInnerColour = "#888888";
constexpr double kOutlineWidth = 1.2;
constexpr std::string_view kMarkedColour = "#d00000";
constexpr double kMarkedWidth = 2;
constexpr double kLeastRing = 8;
constexpr double kRingGap = 4;
constexpr std::string_view kNumberColour = "#005080";
constexpr double kNumberSize = 12;
constexpr Point kNumberBeside{6, 4};

/// Places of the parts.
struct Layout {
  Point scene_room;
  bool chart_beside = false;
};

Box bounds(const Frame& start, const Frame& end) {
  Box box;
  for (const Frame* frame : {&start, &end})
    for (const ElementFrame& element : frame->elements)
      for (const std::vector<Point>& loop : element.loops)
        for (Point p : loop) box.include(p);
  return box;
}

/// Returns the picture without the elements that are left out.
RunPicture framed(RunPicture picture) {
  Frame& end = picture.end;
  for (std::size_t i = 0; i < end.elements.size(); ++i)
    end.elements[i].number = number_of(end, i);  // also where others are taken away
  if (!picture.left_out.empty()) end.elements = without(end.elements, picture.left_out);
  return picture;
}

Layout choose_layout(const Box& box, bool chart) {
  if (!chart) return {{kRoom, 640}, false};
  const bool tall = !box.empty() && box.height() > 1.1 * box.width();
  return tall ? Layout{{300, 560}, true} : Layout{{kRoom, 440}, false};
}

/// Returns true if the move of an element is visible: some vertex moved further than a page unit.
bool moved_visibly(const PageMap& map, const ElementFrame& start, const ElementFrame& end) {
  if (start.loops.empty() || end.loops.empty() || start.loops[0].size() != end.loops[0].size()) return true;
  for (std::size_t i = 0; i < start.loops[0].size(); ++i)
    if (distance(map(start.loops[0][i]), map(end.loops[0][i])) > 1) return true;
  return false;
}

/// Blocks with a fixed point at the end, by their numbers. Bodies of many elements are shown by their supports alone.
class HeldBlocks {
 public:
  explicit HeldBlocks(const Frame& end) {
    if (!end.outlines.empty()) return;
    for (const PointFrame& point : end.fixed_points) numbers_.push_back(point.element);
    std::ranges::sort(numbers_);
  }
  bool empty() const { return numbers_.empty(); }
  bool contains(int number) const { return std::ranges::binary_search(numbers_, number); }

 private:
  std::vector<int> numbers_;
};

/// Elements inside a body are drawn by thin lines, its outline by a strong one.
void draw_end(SvgPage& page, const PageMap& map, const Frame& end, double width) {
  const bool has_outlines = !end.outlines.empty();
  const HeldBlocks held(end);
  for (std::size_t i = 0; i < end.elements.size(); ++i) {
    const ElementFrame& element = end.elements[i];
    page.polygon(map(element.loops),
                 {.fill = held.contains(number_of(end, i)) ? kHeldColour : area_colour(element.material),
                  .stroke = has_outlines ? kInnerColour : "#333333",
                  .stroke_width = has_outlines ? width / 2 : width});
  }
}

/// Returns the materials of joints; empty if all edges have one.
std::set<int> told_apart(const RunPicture& picture) {
  std::set<int> materials;
  for (const std::vector<int>& of_element : picture.joints) materials.insert(of_element.begin(), of_element.end());
  materials.erase(materials.begin(), materials.lower_bound(0));
  return materials.size() > 1 ? materials : std::set<int>();
}

void draw_joints(SvgPage& page, const PageMap& map, const RunPicture& picture, double width) {
  if (told_apart(picture).empty()) return;
  for (const ElementFrame& element : picture.end.elements) {
    const auto number = static_cast<std::size_t>(element.number);
    if (number >= picture.joints.size()) continue;
    const std::vector<int>& joints = picture.joints[number];
    std::size_t corners = 0;
    for (const std::vector<Point>& loop : element.loops) corners += loop.size();
    if (corners != joints.size()) continue;
    auto first = joints.begin();
    for (const std::vector<Point>& loop : element.loops) {
      const auto last = first + static_cast<std::ptrdiff_t>(loop.size());
      draw_joint_edges(page, map(loop), {first, last}, width);
      first = last;
    }
  }
}

/// Draws outlines of moved elements only; others would hide the picture.
void draw_start(SvgPage& page, const PageMap& map, const RunPicture& picture, double width) {
  const Style dashed{.stroke = kStartColour, .stroke_width = std::min(width, 1.0), .dash = width > 0.5 ? "4 3" : "2 1"};
  for (const std::vector<Point>& outline : picture.start.outlines) page.polygon({map(outline)}, dashed);
  if (!picture.start.outlines.empty()) return;
  const std::vector<ElementFrame>& start = picture.start.elements;
  const ElementsByNumber ends(picture.end);
  for (std::size_t i = 0; i < start.size(); ++i) {
    const ElementFrame* end = ends.find(number_of(picture.start, i));
    if (end != nullptr && !moved_visibly(map, start[i], *end)) continue;
    page.polygon(map(start[i].loops), dashed);
  }
}

void draw_elements(SvgPage& page, const PageMap& map, const RunPicture& picture) {
  const double width = edge_width(map.size(), picture.end.elements.size());
  page.layer([&] { draw_end(page, map, picture.end, width); });
  page.layer([&] {
    for (const std::vector<Point>& outline : picture.end.outlines)
      page.polygon({map(outline)}, {.stroke = "#222222", .stroke_width = kOutlineWidth});
  });
  page.layer([&] {
    draw_joints(page, map, picture, picture.end.outlines.empty() ? width : kOutlineWidth);
    draw_start(page, map, picture, width);
  });
}

/// Marks elements with a ring about each, which shows slivers too.
void draw_marked(SvgPage& page, const PageMap& map, const RunPicture& picture) {
  const ElementsByNumber ends(picture.end);
  for (const int number : picture.marked) {
    const ElementFrame* element = ends.find(number);
    if (element == nullptr || element->loops.empty()) continue;
    page.polygon(map(element->loops), {.stroke = kMarkedColour, .stroke_width = kMarkedWidth});
    Box box;
    for (const Point p : element->loops.front()) box.include(map(p));
    const Point middle = 0.5 * (box.low + box.high);
    page.circle(middle, std::max(kLeastRing, std::hypot(box.width(), box.height()) / 2 + kRingGap),
                {.stroke = kMarkedColour, .stroke_width = kMarkedWidth});
  }
}

/// States of the bolts of the end, in their order.
std::vector<BoltState> bolt_states(const RunPicture& picture) {
  std::vector<BoltState> states;
  for (std::size_t i = 0; i < picture.end.bolts.size(); ++i) {
    const BoltFrame& bolt = picture.end.bolts[i];
    const int number = bolt.number < 0 ? static_cast<int>(i) : bolt.number;
    const bool is_idle = std::ranges::find(picture.idle_bolts, number) != picture.idle_bolts.end();
    states.push_back(bolt.is_broken ? BoltState::broken : is_idle ? BoltState::idle : BoltState::carries);
  }
  return states;
}

void draw_bolts(SvgPage& page, const PageMap& map, const RunPicture& picture) {
  const std::vector<BoltState> states = bolt_states(picture);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const BoltFrame& bolt = picture.end.bolts[i];
    draw_bolt(page, map(bolt.first), map(bolt.second), states[i], bolt.name);
  }
}

void draw_marks(SvgPage& page, const PageMap& map, const Frame& frame) {
  for (const PointFrame& point : frame.fixed_points) draw_mark(page, map(point.position), Mark::fixed_point);
  for (const PointFrame& point : frame.loading_points) draw_mark(page, map(point.position), Mark::loading_point);
  for (const PointFrame& point : frame.measured_points) draw_mark(page, map(point.position), Mark::measured_point);
}

std::string time_words(std::string_view word, double time, const std::string& unit) {
  return fmt::format("{}, t = {:g}{}{}", word, time, unit.empty() ? "" : " ", unit);
}

/// Writes numbers on white, readable over edges.
void draw_numbers(SvgPage& page, const PageMap& map, const RunPicture& picture) {
  for (const NumberedPlace& number : picture.numbers) {
    const Point at = map(number.at) + kNumberBeside;
    page.rectangle(at - Point{2, kNumberSize - 1}, text_width(number.words, kNumberSize) + 4, kNumberSize + 2,
                   {.fill = "#ffffff"});
    page.text(at, number.words, {.size = kNumberSize, .fill = kNumberColour, .bold = true});
  }
}

/// Returns the colour of the first free element.
std::string_view colour_of_end(const Frame& end, const HeldBlocks& held) {
  for (std::size_t i = 0; i < end.elements.size(); ++i)
    if (!held.contains(number_of(end, i))) return area_colour(end.elements[i].material);
  return end.elements.empty() ? area_colour(0) : kHeldColour;
}

std::vector<LegendEntry> make_legend(const RunPicture& picture) {
  using Sign = LegendEntry::Sign;
  const HeldBlocks held(picture.end);
  std::vector<LegendEntry> legend{{.sign = Sign::dashed_line,
                                   .colour = kStartColour,
                                   .words = time_words("start", picture.start.time, picture.time_unit)},
                                  {.sign = Sign::area,
                                   .colour = colour_of_end(picture.end, held),
                                   .words = time_words("end", picture.end.time, picture.time_unit)}};
  std::set<int> materials;
  for (std::size_t i = 0; i < picture.end.elements.size(); ++i)
    if (!held.contains(number_of(picture.end, i))) materials.insert(picture.end.elements[i].material);
  if (!held.empty()) legend.push_back({.sign = Sign::area, .colour = kHeldColour, .words = "fixed block"});
  if (materials.size() > 1) add_numbered(legend, materials, Sign::area, "block material", picture.rock_names);
  add_numbered(legend, told_apart(picture), Sign::line, "joint material", picture.joint_names);
  const auto add = [&legend](const std::vector<PointFrame>& points, Mark mark, std::string_view words) {
    if (!points.empty())
      legend.push_back({.sign = Sign::mark, .colour = {}, .mark = mark, .words = std::string(words)});
  };
  add(picture.end.fixed_points, Mark::fixed_point, "fixed point");
  add(picture.end.loading_points, Mark::loading_point, "loading point");
  add(picture.end.measured_points, Mark::measured_point, "measured point");
  if (!picture.marked.empty())
    legend.push_back({.sign = Sign::dashed_line, .colour = kMarkedColour, .words = picture.marked_words});
  add_bolts(legend, bolt_states(picture));
  if (!picture.numbers.empty())
    legend.push_back({.sign = Sign::number, .colour = kNumberColour, .words = picture.numbered_words});
  if (!picture.left_out.empty())
    legend.push_back({.sign = Sign::area, .colour = "none", .words = outside_in_words(picture.left_out.size())});
  return legend;
}

}  // namespace

std::vector<std::size_t> left_out_of(const Frame& start, const Frame& end, const std::vector<int>& marked) {
  if (!end.outlines.empty() || !end.bolts.empty()) return {};
  std::set<int> shown(marked.begin(), marked.end());
  for (const auto* points : {&end.fixed_points, &end.loading_points, &end.measured_points})
    for (const PointFrame& point : *points) shown.insert(point.element);
  std::vector<PlacedBlock> blocks;
  for (std::size_t i = 0; i < end.elements.size(); ++i)
    blocks.push_back({end.elements[i].centroid, end.elements[i].area, shown.contains(number_of(end, i))});
  return far_small_blocks(bounds(start, {}), blocks);
}

std::string run_picture(RunPicture whole) {
  RunPicture picture = framed(std::move(whole));
  const bool chart = std::ranges::any_of(picture.curves, [](const Curve& curve) { return curve.x.size() > 1; });
  if (!chart) picture.numbers.clear();
  const Box box = bounds(picture.start, picture.end);
  const Layout layout = choose_layout(box, chart);
  const std::vector<LegendEntry> legend = make_legend(picture);
  const double scene_top = kTitleHeight + legend_height(legend, kRoom) + 12;
  const Point size = PageMap(box, {}, layout.scene_room).size();
  const PageMap map(box, {kMargin + (layout.scene_room.x - size.x) / 2, scene_top}, layout.scene_room);
  const double bar_line = scene_top + size.y + 26;
  const double scene_bottom = bar_line + kScaleBarHeight;
  Point chart_corner{kMargin, scene_bottom};
  Point chart_size{kRoom, 340};
  if (layout.chart_beside) {
    chart_corner = {kMargin + layout.scene_room.x + 30, scene_top};
    chart_size = {kRoom - layout.scene_room.x - 30, 400};
  }
  const double bottom = chart ? std::max(scene_bottom, chart_corner.y + chart_size.y) : scene_bottom;
  SvgPage page(kPageWidth, bottom + 14);
  page.text({kMargin, 28}, picture.title, {.size = 17, .bold = true});
  draw_legend(page, {kMargin, kTitleHeight}, kRoom, legend);
  if (!box.empty()) {
    draw_elements(page, map, picture);
    page.layer([&] { draw_bolts(page, map, picture); });
    page.layer([&] { draw_marks(page, map, picture.end); });
    page.layer([&] { draw_marked(page, map, picture); });
    draw_numbers(page, map, picture);
    draw_scale_bar(page, {kMargin, bar_line}, std::min(layout.scene_room.x, kRoom), map, picture.units);
  }
  if (chart) draw_chart(page, chart_corner, chart_size, picture.curves, picture.axes);
  return page.str();
}

}  // namespace keyblock::report
