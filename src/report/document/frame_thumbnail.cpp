// Fits the bodies to the picture; edges are drawn while there are few of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/document/frame_thumbnail.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/polygon.hpp"
#include "report/drawing/colours.hpp"
#include "report/drawing/svg.hpp"

namespace keyblock::report {
namespace {

constexpr Point kSize{264, 168};
constexpr double kMargin = 4;
constexpr std::size_t kMostEdged = 600;

struct Shape {
  std::vector<std::vector<Point>> loops;
  int material = 0;
  double size = 0;
};

Shape shape_of(const FieldElement& element) {
  Shape shape;
  for (const std::vector<FieldCorner>& loop : element.loops) {
    std::vector<Point>& points = shape.loops.emplace_back();
    for (const FieldCorner& corner : loop) points.push_back(corner.position + corner.displacement);
  }
  shape.material = element.material;
  shape.size = std::abs(area(shape.loops.front()));
  return shape;
}

}  // namespace

std::string frame_thumbnail(const FieldFrame& frame) {
  std::vector<Shape> shapes;
  for (const FieldElement& element : frame.elements)
    if (!element.loops.empty() && element.loops.front().size() > 2) shapes.push_back(shape_of(element));
  if (shapes.empty()) return {};
  std::ranges::stable_sort(shapes, std::greater<>{}, &Shape::size);
  if (shapes.size() > kCardShapes) shapes.resize(kCardShapes);
  Box box;
  for (const Shape& shape : shapes)
    for (const Point point : shape.loops.front()) box.include(point);
  const PageMap map(box, {kMargin, kMargin}, {kSize.x - 2 * kMargin, kSize.y - 2 * kMargin});
  const double edge = shapes.size() > kMostEdged ? 0.1 : 0.5;
  SvgPage page(kSize.x, kSize.y);
  for (const Shape& shape : shapes)
    page.polygon(map(shape.loops), {.fill = area_colour(shape.material), .stroke = "#444444", .stroke_width = edge});
  return page.str();
}

}  // namespace keyblock::report
