// Measures a contact: normal, point and gap, on an edge or on the arc between two corners.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "contact/find/touch.hpp"

namespace keyblock {
Point outward_normal(VertexIndex start, VertexIndex end, const Table<VertexIndex, Point>& vertices) {
  const Point along = vertices[end] - vertices[start];
  return (1 / length(along)) * Point{along.y, -along.x};
}

namespace {

// A foot beyond the end of its edge by this fraction of it counts as at the end.
constexpr double kAtEnd = 1e-9;

struct Nearest {
  Point normal;
  double gap = 0;
  double share = 0;  ///< fraction of the second line in the normal: 0 or 1 on a line
};

// Finds the nearest point on two lines and the circle that touches both at equal distances from their crossing. The
// position of the corners across the bisector determines the normal, on the circle or a line, at any depth of overlap.
Nearest nearest_on_arc(const Touch& arc, const Table<VertexIndex, Point>& vertices) {
  const auto normal = [&](EdgeName guide) {
    return (guide.has(arc.vertex) ? -1.0 : 1.0) * outward_normal(guide.start, guide.end, vertices);
  };
  const Point first = normal(arc.first), second = normal(arc.second);
  const Point apart = vertices[arc.vertex] - vertices[arc.start];
  const Point sum = first + second;
  const Point bisector = (1 / length(sum)) * sum, across{-bisector.y, bisector.x};
  const double cosine = length(sum) / 2, widest = arc.tangent * cosine, place = dot(across, apart);
  if (place <= -widest) return {first, dot(first, apart), 0};
  if (place >= widest) return {second, dot(second, apart), 1};
  const double radius = widest / dot(across, second);
  const double sine = place / radius, along = std::sqrt(1 - sine * sine);
  const double height = radius * (along - 1 / cosine);
  return {along * bisector + sine * across, along * (dot(bisector, apart) - height), (1 + place / widest) / 2};
}

}  // namespace

Touch guided(const Touch& arc, EdgeName guide) {
  return {guide.has(arc.vertex) ? arc.start : arc.vertex, guide.start, guide.end};
}

bool is_guided(const Touch& touch, const Touch& arc) {
  return arc.kind == TouchKind::arc && (touch == guided(arc, arc.first) || touch == guided(arc, arc.second));
}

double share_of_second(const Touch& arc, const Table<VertexIndex, Point>& vertices) {
  return nearest_on_arc(arc, vertices).share;
}

Point normal_of(const Touch& touch, const Table<VertexIndex, Point>& vertices) {
  if (touch.kind == TouchKind::arc) return nearest_on_arc(touch, vertices).normal;
  return outward_normal(touch.start, touch.end, vertices);
}

Point point_of(const Touch& touch, const Table<VertexIndex, Point>& vertices) {
  if (touch.kind != TouchKind::middle) return vertices[touch.vertex];
  return (1 - touch.along) * vertices[touch.vertex] + touch.along * vertices[touch.other];
}

double gap_of(const Touch& touch, const Table<VertexIndex, Point>& vertices) {
  if (touch.kind == TouchKind::arc) return nearest_on_arc(touch, vertices).gap;
  return dot(normal_of(touch, vertices), point_of(touch, vertices) - vertices[touch.start]);
}

bool lies_over_edge(const Touch& touch, const Table<VertexIndex, Point>& vertices) {
  if (touch.kind == TouchKind::arc) {
    const double share = share_of_second(touch, vertices);
    return (share > 0 && share < 1) || lies_over_edge(guided(touch, share == 0 ? touch.first : touch.second), vertices);
  }
  const Point edge = vertices[touch.end] - vertices[touch.start];
  const double station = dot(point_of(touch, vertices) - vertices[touch.start], edge) / dot(edge, edge);
  return (touch.before_start || station >= -kAtEnd) && (touch.beyond_end || station <= 1 + kAtEnd);
}

}  // namespace keyblock
