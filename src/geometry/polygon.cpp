// Measures of polygons; see polygon.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polygon.hpp"

#include <algorithm>

#include "geometry/predicates.hpp"

namespace keyblock {
namespace {

bool is_between(double a, double b, double value) {
  return std::min(a, b) <= value && value <= std::max(a, b);
}

}  // namespace

double area(std::span<const Point> loop) {
  double twice = 0;
  for (std::size_t i = 2; i < loop.size(); ++i) twice += cross(loop[i - 1] - loop[0], loop[i] - loop[0]);
  return twice / 2;
}

Point centroid(std::span<const Point> loop) {
  Point moment;
  Point sum;
  double twice = 0;
  for (std::size_t i = 1; i < loop.size(); ++i) {
    const Point a = loop[i - 1] - loop[0];
    const Point b = loop[i] - loop[0];
    moment = moment + cross(a, b) * (a + b);
    sum = sum + b;
    twice += cross(a, b);
  }
  if (twice == 0) return loop.empty() ? Point{} : loop[0] + (1.0 / static_cast<double>(loop.size())) * sum;
  return loop[0] + (1 / (3 * twice)) * moment;
}

Side side(std::span<const Point> loop, Point p) {
  bool is_inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point a = loop[i];
    const Point b = loop[i + 1 == loop.size() ? 0 : i + 1];
    if (!is_between(a.y, b.y, p.y)) continue;
    if (a.x > p.x && b.x > p.x && (a.y > p.y) == (b.y > p.y)) continue;
    const int where = orientation(a, b, p);
    if (where == 0 && is_between(a.x, b.x, p.x)) return Side::on_edge;
    // An edge counts with its lower end and without its upper one, so a vertex is counted once.
    if ((a.y > p.y) != (b.y > p.y) && (where > 0) == (b.y > a.y)) is_inside = !is_inside;
  }
  return is_inside ? Side::inside : Side::outside;
}

std::optional<Point> point_inside(std::span<const std::vector<Point>> loops) {
  std::vector<double> heights;
  for (const std::vector<Point>& loop : loops)
    for (const Point p : loop) heights.push_back(p.y);
  if (heights.empty()) return std::nullopt;
  std::ranges::sort(heights);
  double y = heights.front(), widest = 0;
  for (std::size_t i = 1; i < heights.size(); ++i)
    if (heights[i] - heights[i - 1] > widest) {
      widest = heights[i] - heights[i - 1];
      y = heights[i - 1] + widest / 2;
    }
  std::vector<double> crossings;
  for (const std::vector<Point>& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point a = loop[i], b = loop[i + 1 == loop.size() ? 0 : i + 1];
      if ((a.y < y) != (b.y < y)) crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
  std::ranges::sort(crossings);
  if (crossings.size() < 2 || crossings[0] == crossings[1]) return std::nullopt;
  return Point{(crossings[0] + crossings[1]) / 2, y};
}

std::vector<Point> part_left_of(const std::vector<Point>& polygon, Point start, Point end) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point here = polygon[i];
    const Point next = polygon[(i + 1) % polygon.size()];
    const double at_here = cross(end - start, here - start);
    const double at_next = cross(end - start, next - start);
    if (at_here >= 0) kept.push_back(here);
    if ((at_here > 0 && at_next < 0) || (at_here < 0 && at_next > 0))
      kept.push_back(here + (at_here / (at_here - at_next)) * (next - here));
  }
  return kept;
}

}  // namespace keyblock
