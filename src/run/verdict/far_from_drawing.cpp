// Goes through the outlines as drawn; a block is one outline, an NMM body all elements of its number.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/verdict/far_from_drawing.hpp"

#include <algorithm>
#include <vector>

#include "geometry/polygon.hpp"
#include "model/continuum.hpp"

namespace keyblock {
namespace {

// Fraction of the median area of free blocks, below which a block is loose.
constexpr double kLoose = 0.01;

double area_of(const FieldElement& element) {
  double sum = 0;
  for (const auto& loop : element.loops) {
    std::vector<Point> points;
    for (const FieldCorner& corner : loop) points.push_back(corner.position);
    sum += area(points);  // holes are clockwise
  }
  return sum;
}

/// Outline, or a whole body.
struct Whole {
  std::vector<std::size_t> elements;
  double area = 0;
  bool is_held = false;
};

std::vector<Whole> wholes_of(const Model& model, const Frame& end, const FieldFrame& field) {
  std::vector<Whole> wholes(body_count(field));
  const auto of = [&](std::size_t e) -> Whole& { return wholes[static_cast<std::size_t>(field.elements[e].body)]; };
  for (std::size_t e = 0; e < field.elements.size(); ++e) {
    of(e).elements.push_back(e);
    of(e).area += area_of(field.elements[e]);
  }
  for (const PointFrame& point : end.fixed_points)
    for (std::size_t e = 0; e < end.elements.size(); ++e)
      if (number_of(end, e) == point.element) of(e).is_held = true;
  if (!model.continuum) return wholes;
  // NMM elements are the last ones.
  const std::size_t first = field.elements.size() - model.continuum->manifold.elements.size();
  for (const PrescribedDisplacement& held : model.continuum->prescribed)
    for (const ElementSide& side : sides_along(model.continuum->manifold, held.along))
      of(first + static_cast<std::size_t>(side.element)).is_held = true;
  for (const PointSpring& spring : model.continuum->point_springs)
    of(first + static_cast<std::size_t>(spring.element)).is_held = true;
  return wholes;
}

double farthest_driven(const Model& model, const Frame& end) {
  double farthest = 0;
  for (const PointFrame& point : end.fixed_points) farthest = std::max(farthest, length(point.displacement));
  if (!model.continuum) return farthest;
  for (const PrescribedDisplacement& held : model.continuum->prescribed)
    for (const Point& at : held.along) farthest = std::max(farthest, length(held.value(at, {0, 1})));
  return farthest;
}

// Takes the vertex that moved farthest.
CarriedBlock carried_block(const FieldElement& element) {
  CarriedBlock found;
  for (const auto& loop : element.loops)
    for (const FieldCorner& corner : loop)
      if (const double way = length(corner.displacement); way > found.way) {
        found.way = way;
        found.drawn = corner.position;
      }
  return found;
}

CarriedBlock carried_body(const Whole& whole, const FieldFrame& field) {
  CarriedBlock found;
  found.is_body = true;
  Point way;
  for (const std::size_t e : whole.elements) {
    const double share = area_of(field.elements[e]) / whole.area;
    way = way + share * field.elements[e].middle.displacement;
    found.drawn = found.drawn + share * field.elements[e].middle.position;
  }
  found.way = length(way);
  return found;
}

// The width is independent of the axes and takes one pass over the vertices.
double width_of(const Whole& whole, const FieldFrame& field) {
  Point centre;
  for (const std::size_t e : whole.elements)
    centre = centre + area_of(field.elements[e]) / whole.area * field.elements[e].middle.position;
  double farthest = 0;
  for (const std::size_t e : whole.elements)
    for (const auto& loop : field.elements[e].loops)
      for (const FieldCorner& corner : loop) farthest = std::max(farthest, distance(centre, corner.position));
  return farthest > 0 ? whole.area / (2 * farthest) : 0;
}

double median_of_free(const std::vector<Whole>& wholes) {
  std::vector<double> areas;
  for (const Whole& whole : wholes)
    if (!whole.is_held) areas.push_back(whole.area);
  if (areas.empty()) return 0;
  const auto middle = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
  std::ranges::nth_element(areas, middle);
  return *middle;
}

}  // namespace

std::optional<CarriedBlock> farthest_carried(const Model& model, const Frame& end, const FieldFrame& field,
                                             bool loose) {
  if (field.elements.empty() || field.elements.size() != end.elements.size() ||
      field.elements.size() != model.elements.size())
    return std::nullopt;
  const std::vector<Whole> wholes = wholes_of(model, end, field);
  const double driven = farthest_driven(model, end);
  const double least_area = kLoose * median_of_free(wholes);
  std::optional<CarriedBlock> farthest;
  for (const Whole& whole : wholes) {
    if (whole.elements.empty() || (whole.area < least_area) != loose) continue;
    const std::size_t first = whole.elements.front();
    const bool is_body = model.elements[ElementIndex{static_cast<int>(first)}].is_on_covers();
    if (is_body && whole.is_held) continue;
    CarriedBlock found = is_body ? carried_body(whole, field) : carried_block(field.elements[first]);
    found.number = number_of(end, first);
    found.way = std::max(0.0, found.way - driven);
    found.width = width_of(whole, field);
    found.is_loose = loose;
    if (found.way > 0 && (!farthest || found.share() > farthest->share())) farthest = found;
  }
  return farthest;
}

}  // namespace keyblock
