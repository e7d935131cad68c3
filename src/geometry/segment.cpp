// Relations of segments; see segment.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/segment.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.hpp"

namespace keyblock {
namespace {

bool boxes_meet(const Segment& a, const Segment& b) {
  const auto [ax0, ax1] = std::minmax(a.start.x, a.end.x);
  const auto [bx0, bx1] = std::minmax(b.start.x, b.end.x);
  const auto [ay0, ay1] = std::minmax(a.start.y, a.end.y);
  const auto [by0, by1] = std::minmax(b.start.y, b.end.y);
  return ax0 <= bx1 && bx0 <= ax1 && ay0 <= by1 && by0 <= ay1;
}

}  // namespace

Point point_at(const Segment& segment, double t) {
  return {segment.start.x + (segment.end.x - segment.start.x) * t,
          segment.start.y + (segment.end.y - segment.start.y) * t};
}

double foot(const Segment& segment, Point p) {
  const Point along = segment.end - segment.start;
  const double square = dot(along, along);
  return square > 0 ? dot(p - segment.start, along) / square : 0;
}

double distance(const Segment& segment, Point p) {
  return distance(point_at(segment, std::clamp(foot(segment, p), 0.0, 1.0)), p);
}

double distance_to_carrier(const Segment& segment, Point p) {
  const Point along = segment.end - segment.start;
  const double span = length(along);
  return span > 0 ? std::fabs(cross(along, p - segment.start)) / span : distance(segment.start, p);
}

Meeting meeting(const Segment& a, const Segment& b) {
  if (!boxes_meet(a, b)) return Meeting::none;
  const int b_start = orientation(a.start, a.end, b.start);
  const int b_end = orientation(a.start, a.end, b.end);
  if (b_start * b_end > 0) return Meeting::none;
  // On one straight line the boxes meet exactly where the segments do.
  if (b_start == 0 && b_end == 0) return Meeting::overlapping;
  const int a_start = orientation(b.start, b.end, a.start);
  const int a_end = orientation(b.start, b.end, a.end);
  return a_start * a_end > 0 ? Meeting::none : Meeting::crossing;
}

}  // namespace keyblock
