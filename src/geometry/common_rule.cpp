// Clips the triangles of two fans pair by pair.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/common_rule.hpp"

#include <algorithm>
#include <array>

#include "geometry/box.hpp"
#include "geometry/polygon.hpp"

namespace keyblock {
namespace {

struct SignedTriangle {
  std::array<Point, 3> corners;  // counter-clockwise
  double sign = 1;
};

std::vector<SignedTriangle> triangles_about(std::span<const std::vector<Point>> loops) {
  std::vector<SignedTriangle> fan;
  for (const std::vector<Point>& loop : loops)
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      const double twice = cross(loop[i] - loop[0], loop[i + 1] - loop[0]);
      if (twice > 0) fan.push_back({{loop[0], loop[i], loop[i + 1]}, 1});
      if (twice < 0) fan.push_back({{loop[0], loop[i + 1], loop[i]}, -1});
    }
  return fan;
}

Box box_of(const SignedTriangle& triangle) {
  Box box;
  for (const Point& p : triangle.corners) box.add(p);
  return box;
}

bool overlap(const Box& a, const Box& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

std::vector<Point> common_part(const SignedTriangle& a, const SignedTriangle& b) {
  std::vector<Point> part(a.corners.begin(), a.corners.end());
  for (std::size_t i = 0; i < 3 && part.size() > 2; ++i)
    part = part_left_of(part, b.corners[i], b.corners[(i + 1) % 3]);
  return part;
}

}  // namespace

std::vector<AreaPoint> common_rule(std::span<const std::vector<Point>> a, std::span<const std::vector<Point>> b,
                                   int degree) {
  std::vector<AreaPoint> rule;
  const std::vector<SignedTriangle> others = triangles_about(b);
  for (const SignedTriangle& one : triangles_about(a)) {
    const Box box = box_of(one);
    for (const SignedTriangle& other : others) {
      if (!overlap(box, box_of(other))) continue;
      const std::vector<Point> part = common_part(one, other);
      for (std::size_t i = 1; i + 1 < part.size(); ++i)
        for (AreaPoint point : triangle_rule({part[0], part[i], part[i + 1]}, degree)) {
          point.weight *= one.sign * other.sign;
          rule.push_back(point);
        }
    }
  }
  return rule;
}

}  // namespace keyblock
