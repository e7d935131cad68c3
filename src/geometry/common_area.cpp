// Computes common areas from both bodies as sums of signed triangles from one point. The common area is the sum over
// pairs of triangles, which clip each other without special cases (Sutherland & Hodgman 1974).
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/common_area.hpp"

#include <algorithm>
#include <array>

#include "geometry/box.hpp"
#include "geometry/polygon.hpp"

namespace keyblock {
namespace {

using Triangle = std::array<Point, 3>;

/// Counter-clockwise triangle with the sign of its original order.
struct Signed {
  Triangle corners;
  double sign = 0;
};

std::vector<Signed> fan_of(const Loops& loops, Point centre) {
  std::vector<Signed> fan;
  for (const std::vector<Point>& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point from = loop[i] - centre;
      const Point to = loop[(i + 1) % loop.size()] - centre;
      const double twice = cross(from, to);
      if (twice > 0) fan.push_back({{Point{}, from, to}, 1});
      if (twice < 0) fan.push_back({{Point{}, to, from}, -1});
    }
  }
  return fan;
}

double common_area(const Triangle& a, const Triangle& b) {
  std::vector<Point> rest(a.begin(), a.end());
  for (std::size_t k = 0; k < 3 && rest.size() > 2; ++k) rest = part_left_of(rest, b[k], b[(k + 1) % 3]);
  return rest.size() > 2 ? area(rest) : 0;
}

/// Returns true if an edge of `a` has all of `b` on its right or on it; b then lies outside a.
bool has_beyond(const std::vector<Point>& a, const std::vector<Point>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point start = a[i];
    const Point along = a[(i + 1) % a.size()] - start;
    const auto is_right = [&](Point p) { return cross(along, p - start) <= 0; };
    const auto is_left = [&](Point p) { return cross(along, p - start) >= 0; };
    if (std::ranges::all_of(b, is_right) && std::ranges::all_of(a, is_left)) return true;
  }
  return false;
}

}  // namespace

double common_area(const Loops& a, const Loops& b) {
  if (a.empty() || b.empty() || has_beyond(a.front(), b.front()) || has_beyond(b.front(), a.front())) return 0;
  Box box;
  for (Point p : b.front()) box.add(p);
  const Point centre = box.middle();
  const std::vector<Signed> of_b = fan_of(b, centre);
  double sum = 0;
  for (const Signed& s : fan_of(a, centre))
    for (const Signed& t : of_b) sum += s.sign * t.sign * common_area(s.corners, t.corners);
  return sum;
}

}  // namespace keyblock
