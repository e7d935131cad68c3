// Draws what can be seen at the size of a stamp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/thumbnail.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/polygon.hpp"
#include "report/drawing/colours.hpp"
#include "report/drawing/svg.hpp"

namespace keyblock::report {
namespace {

constexpr Point kSize{132, 84};
constexpr double kEdge = 2;
constexpr std::size_t kMostEdged = 600;  // shapes of a card with edges that are seen

using Chains = std::vector<std::vector<Point>>;

/// Loops filled together, the inner ones as holes.
struct Shape {
  std::vector<std::vector<Point>> loops;
  int material = 0;
  double size = 0;  ///< by which the shapes worth drawing are chosen
};

PageMap map_of(const Box& box, double scale = 1) {
  return {box, scale * Point{kEdge, kEdge}, scale * (kSize - 2 * Point{kEdge, kEdge})};
}

// Writes the element without the head of a document.
std::string element_of(const SvgPage& page) {
  const std::string document = page.str();
  return document.substr(document.find("<svg"));
}

void draw_cracks(SvgPage& page, const PageMap& map, const Chains& cracks) {
  for (const std::vector<Point>& own : map(cracks)) page.polyline(own, {.stroke = "#000000", .stroke_width = 1.2});
}

std::string drawn(std::vector<Shape> shapes, std::size_t most, double scale, double edge, const Chains& cracks = {}) {
  std::ranges::stable_sort(shapes, std::greater<>{}, &Shape::size);
  if (shapes.size() > most) shapes.resize(most);
  Box box;
  for (const Shape& shape : shapes)
    for (Point p : shape.loops.front()) box.include(p);
  const PageMap map = map_of(box, scale);
  SvgPage page(scale * kSize.x, scale * kSize.y);
  for (const Shape& shape : shapes)
    page.polygon(map(shape.loops), {.fill = area_colour(shape.material), .stroke = "#444444", .stroke_width = edge});
  draw_cracks(page, map, cracks);
  return element_of(page);
}

}  // namespace

std::string thumbnail(const Blocks& blocks, const Chains& cracks) {
  std::vector<Shape> shapes;
  for (const BlockPolygon& block : blocks.blocks) {
    Shape shape{{points_of(block.outer)}, block.material, std::abs(area(points_of(block.outer)))};
    for (const BlockLoop& hole : block.holes) shape.loops.push_back(points_of(hole));
    shapes.push_back(std::move(shape));
  }
  return drawn(std::move(shapes), kThumbnailShapes, 1, 0.4, cracks);
}

std::string thumbnail(const FieldFrame& frame) {
  std::vector<Shape> shapes;
  for (const FieldElement& element : frame.elements) {
    if (element.loops.empty() || element.loops.front().size() < 3) continue;
    Shape& shape = shapes.emplace_back();
    for (const std::vector<FieldCorner>& loop : element.loops) {
      std::vector<Point>& points = shape.loops.emplace_back();
      for (const FieldCorner& corner : loop) points.push_back(corner.position + corner.displacement);
    }
    shape.material = element.material;
    shape.size = std::abs(area(shape.loops.front()));
  }
  if (shapes.empty()) return {};
  const double edge = std::min(shapes.size(), kCardShapes) > kMostEdged ? 0.1 : 0.5;
  return drawn(std::move(shapes), kCardShapes, 2, edge);
}

std::string thumbnail(const Cover& cover, const Chains& cracks) {
  std::vector<std::vector<Point>> loops;  // filled together: a hole is a loop of its own
  for (const SlotRange& loop : cover.loops) loops.push_back(cover.corners(loop));
  std::ranges::stable_sort(loops, std::greater<>{}, [](const auto& loop) { return std::abs(area(loop)); });
  if (loops.size() > kThumbnailShapes) loops.resize(kThumbnailShapes);
  Box box;
  for (const auto& loop : loops)
    for (Point p : loop) box.include(p);
  SvgPage page(kSize.x, kSize.y);
  const PageMap map = map_of(box);
  page.polygon(map(loops), {.fill = area_colour(0), .stroke = "#444444", .stroke_width = 0.4});
  draw_cracks(page, map, cracks);
  return element_of(page);
}

std::string thumbnail(const Drawing& drawing, const Chains& cracks) {
  std::vector<const JointLine*> lines;
  Box box;
  for (const JointLine& line : drawing.joints) {
    lines.push_back(&line);
    for (Point p : {line.segment.start, line.segment.end}) box.include(p);
  }
  std::ranges::stable_sort(lines, std::greater<>{},
                           [](const JointLine* line) { return distance(line->segment.start, line->segment.end); });
  if (lines.size() > kThumbnailShapes) lines.resize(kThumbnailShapes);
  const PageMap map = map_of(box);
  SvgPage page(kSize.x, kSize.y);
  for (const JointLine* line : lines)
    page.line(map(line->segment.start), map(line->segment.end),
              {.stroke = line_colour(line->joint_material), .stroke_width = 0.6});
  draw_cracks(page, map, cracks);
  return element_of(page);
}

}  // namespace keyblock::report
