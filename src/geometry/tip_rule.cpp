// Places points by the transformations of the header; see tip_rule.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/tip_rule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/polygon.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

constexpr int kRadial = 6;      // exact to ρ^11: products of gradients need ρ^6, loads that grow as r² ρ^10
constexpr int kAlong = 12;      // on either side of the foot: 1e-6 for a tip 1e-2 sides from an edge
constexpr int kEdge = 10;       // along an edge
constexpr double kNear = 0.35;  // per size: nearer tips are the apex of fans
constexpr double kOnLine = 1e-14;
// Triangles from a tip outside a polygon cancel in part, and products of functions by such points need not be positive.
// From this distance on, in sizes, the polygon's own triangles suffice to a degree of 28 (1e-6 for the inverse distance
// at 0.2). They are used nearer too if only this share of the triangles is left, beside a sliver.
constexpr double kOwnTriangles = 0.1;
constexpr int kOwnDegree = 28;
constexpr double kLeastLeft = 0.01;
constexpr double kNothingCancels = 1 - 1e-9;

double distance_from(std::span<const std::vector<Point>> loops, Point p) {
  if (side(loops.front(), p) != Side::outside) return 0;
  double least = std::numeric_limits<double>::max();
  for (const std::vector<Point>& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      least = std::min(least, distance(Segment{loop[i], loop[(i + 1) % loop.size()]}, p));
  return least;
}

/// Returns the degree for a tip this far away, in sizes; measured for products of gradients of near-tip fields, 1e-6.
int degree_at(double distance) {
  if (distance >= 2) return 8;
  if (distance >= 1) return 12;
  return distance >= 0.5 ? 16 : 22;
}

/// Adds points of the strip of the edge from v0 to v1 > v0, both on one side of the foot.
void add_strip(Point tip, Point foot, Point along, double d, double v0, double v1, double sign,
               std::vector<AreaPoint>& points) {
  const double u0 = std::asinh(v0 / d), u1 = std::asinh(v1 / d);
  for (const GaussPoint& a : gauss_rule(kAlong)) {
    const double u = u0 + a.at * (u1 - u0);
    const Point edge = foot + (d * std::sinh(u)) * along;
    const double dv = (u1 - u0) * a.weight * d * std::cosh(u);
    for (const GaussPoint& r : gauss_rule(kRadial)) {
      const double t = r.at * r.at;
      points.push_back({tip + t * (edge - tip), sign * d * dv * t * 2 * r.at * r.weight});
    }
  }
}

}  // namespace

std::vector<AreaPoint> tip_triangle_rule(Point tip, Point from, Point to) {
  std::vector<AreaPoint> points;
  const double size = distance(from, to);
  const double twice = cross(from - tip, to - tip);
  if (size == 0 || std::abs(twice) <= kOnLine * size * (distance(tip, from) + distance(tip, to))) return points;
  const double d = std::abs(twice) / size;
  const Point along = (1 / size) * (to - from);
  const double start = dot(from - tip, along), end = dot(to - tip, along);
  const Point foot = from - start * along;
  const double sign = twice > 0 ? 1 : -1;
  if (start < 0 && end > 0) {
    add_strip(tip, foot, along, d, start, 0, sign, points);
    add_strip(tip, foot, along, d, 0, end, sign, points);
  } else {
    add_strip(tip, foot, along, d, start, end, sign, points);
  }
  return points;
}

std::vector<AreaPoint> polygon_rule_about(std::span<const Point> tips, std::span<const std::vector<Point>> loops,
                                          double size, int degree) {
  double least = std::numeric_limits<double>::max();
  Point nearest;
  for (const Point tip : tips) {
    const double d = distance_from(loops, tip) / size;
    if (d >= least) continue;
    least = d;
    nearest = tip;
  }
  if (least > kNear) return polygon_rule(loops, tips.empty() ? degree : std::max(degree, degree_at(least)));
  std::vector<AreaPoint> points;
  for (const std::vector<Point>& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::vector<AreaPoint> fan = tip_triangle_rule(nearest, loop[i], loop[(i + 1) % loop.size()]);
      points.insert(points.end(), fan.begin(), fan.end());
    }
  }
  double sum = 0, amounts = 0;
  for (const AreaPoint& point : points) {
    sum += point.weight;
    amounts += std::abs(point.weight);
  }
  const double least_left = least > kOwnTriangles ? kNothingCancels : kLeastLeft;
  return sum > least_left * amounts ? points : polygon_rule(loops, std::max(degree, kOwnDegree));
}

std::vector<EdgePoint> edge_rule_about(std::span<const Point> tips, const Segment& edge) {
  std::vector<EdgePoint> points;
  const double size = distance(edge.start, edge.end);
  double least = std::numeric_limits<double>::max(), at = 0;
  for (const Point tip : tips) {
    if (distance(edge, tip) >= least) continue;
    least = distance(edge, tip);
    at = std::clamp(foot(edge, tip), 0.0, 1.0);
  }
  const auto add = [&](double to) {  // from the foot
    for (const GaussPoint& g : gauss_rule(kEdge)) {
      const double t = at + (to - at) * g.at * g.at;
      points.push_back({point_at(edge, t), size * std::abs(to - at) * 2 * g.at * g.weight});
    }
  };
  if (at > 0) add(0);
  if (at < 1) add(1);
  return points;
}

}  // namespace keyblock
