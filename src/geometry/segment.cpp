// Computes relations of segments; see segment.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/segment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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

// Share of the largest coordinate below which points are not distinguished.
constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();

double rounding_of(const Segment& s) {
  return kRounding * std::max({std::fabs(s.start.x), std::fabs(s.start.y), std::fabs(s.end.x), std::fabs(s.end.y)});
}

/// Part of a segment, as distances from its start.
struct Stretch {
  double from = 0;
  double to = 0;
};

/// Returns the part of the segment (of this length, in this direction) along which `other` runs.
std::optional<Stretch> stretch_along(const Segment& segment, Point direction, double size, const Segment& other,
                                     double near) {
  const Point a = other.start - segment.start, b = other.end - segment.start;
  const double from_a = dot(a, direction), to_b = dot(b, direction);
  const auto [low, high] = std::minmax(from_a, to_b);
  const Stretch common{std::max(low, 0.0), std::min(high, size)};
  if (!(common.to > common.from)) return {};
  const auto is_near = [&](double at) {
    const double share = (at - from_a) / (to_b - from_a);
    return std::fabs((1 - share) * cross(direction, a) + share * cross(direction, b)) <= near;
  };
  if (!is_near(common.from) || !is_near(common.to)) return {};
  return common;
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
  // On one straight line the boxes meet exactly if the segments do.
  if (b_start == 0 && b_end == 0) return Meeting::overlapping;
  const int a_start = orientation(b.start, b.end, a.start);
  const int a_end = orientation(b.start, b.end, a.end);
  return a_start * a_end > 0 ? Meeting::none : Meeting::crossing;
}

std::vector<Segment> parts_along(const Segment& segment, std::span<const Segment> others, double near) {
  const double size = distance(segment.start, segment.end);
  if (!(size > 0)) return {};
  const Point direction = (1 / size) * (segment.end - segment.start);
  const double rounding = rounding_of(segment);
  std::vector<Stretch> stretches;
  for (const Segment& other : others)
    if (const auto stretch = stretch_along(segment, direction, size, other, near)) stretches.push_back(*stretch);
  std::ranges::sort(stretches, {}, &Stretch::from);
  std::vector<Stretch> joined;
  for (const Stretch& next : stretches) {
    if (joined.empty() || next.from > joined.back().to + rounding)
      joined.push_back(next);
    else
      joined.back().to = std::max(joined.back().to, next.to);
  }
  std::vector<Segment> parts;
  for (const Stretch& part : joined) {
    if (part.to - part.from <= rounding) continue;
    parts.push_back({part.from <= rounding ? segment.start : point_at(segment, part.from / size),
                     part.to >= size - rounding ? segment.end : point_at(segment, part.to / size)});
  }
  return parts;
}

}  // namespace keyblock
