// Defines a point of the plane and the few operations that every other module needs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace keyblock {

/// Point or vector of the plane; x to the right, y up, in the length unit of the input.
struct Point {
  double x = 0;
  double y = 0;

  bool operator==(const Point&) const = default;
};

constexpr Point operator+(Point a, Point b) {
  return {a.x + b.x, a.y + b.y};
}
constexpr Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y};
}
constexpr Point operator*(double s, Point a) {
  return {s * a.x, s * a.y};
}
constexpr double dot(Point a, Point b) {
  return a.x * b.x + a.y * b.y;
}
/// Returns the z component of a × b: positive if b lies to the left of a.
constexpr double cross(Point a, Point b) {
  return a.x * b.y - a.y * b.x;
}
inline double length(Point a) {
  return std::sqrt(a.x * a.x + a.y * a.y);
}
inline double distance(Point a, Point b) {
  return length(b - a);
}

/// Straight piece from `start` to `end`; equal ends mean a point.
struct Segment {
  Point start;
  Point end;

  bool operator==(const Segment&) const = default;
};

}  // namespace keyblock
