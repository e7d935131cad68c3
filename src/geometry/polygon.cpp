// Measures of polygons; see polygon.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polygon.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/box_tree.hpp"
#include "geometry/predicates.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

bool is_between(double a, double b, double value) {
  return std::min(a, b) <= value && value <= std::max(a, b);
}

/// An edge with its neighbours in the chain, edges without length left out.
struct ChainEdge {
  LoopEdge name;
  Segment line;
  Point before;  ///< the corner before the start
  std::size_t next = 0;
};

std::vector<ChainEdge> chain_edges(std::span<const std::vector<Point>> loops) {
  std::vector<ChainEdge> edges;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const std::vector<Point>& loop = loops[l];
    const std::size_t first = edges.size();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Segment line{loop[i], loop[i + 1 == loop.size() ? 0 : i + 1]};
      if (line.start != line.end) edges.push_back({{l, i}, line, {}, edges.size() + 1});
    }
    if (edges.size() == first) continue;
    edges.back().next = first;
    for (std::size_t k = first; k < edges.size(); ++k) edges[edges[k].next].before = edges[k].line.start;
  }
  return edges;
}

/// On which side of a chain p → at → n a point lies: 1 to the left, -1 to the right, 0 on it.
int side_of_chain(Point p, Point at, Point n, Point q) {
  const int first = orientation(p, at, q);
  const int second = orientation(at, n, q);
  const int bend = orientation(p, at, n);
  if (bend == 0 && agreement(p, at, at, n) < 0) return 0;  // there and back
  if (bend >= 0) return first > 0 && second > 0 ? 1 : first < 0 || second < 0 ? -1 : 0;
  return first > 0 || second > 0 ? 1 : first < 0 && second < 0 ? -1 : 0;
}

/// Whether the chain through the start of `b` passes from one side of the chain through that point of `a` to the other.
bool crosses_at_start(const ChainEdge& a, const ChainEdge& b) {
  const Point at = b.line.start;
  if (at == a.line.end || orientation(a.line.start, a.line.end, at) != 0) return false;
  if (agreement(a.line.start, at, at, a.line.end) < 0) return false;  // beyond the edge
  const Point before = at == a.line.start ? a.before : a.line.start;
  return side_of_chain(before, at, a.line.end, b.before) * side_of_chain(before, at, a.line.end, b.line.end) < 0;
}

bool runs_along(const Segment& a, const Segment& b) {
  if (orientation(a.start, a.end, b.start) != 0 || orientation(a.start, a.end, b.end) != 0) return false;
  return agreement(a.start, a.end, b.start, b.end) > 0 && agreement(a.start, a.end, b.start, a.end) > 0 &&
         agreement(a.start, a.end, a.start, b.end) > 0;
}

/// Where two edges that are no neighbours cross.
std::optional<Point> crossing_of(const ChainEdge& a, const ChainEdge& b) {
  if (crosses_at_start(a, b)) return b.line.start;
  if (crosses_at_start(b, a)) return a.line.start;
  if (runs_along(a.line, b.line))
    return agreement(a.line.start, a.line.end, a.line.start, b.line.start) > 0 ? b.line.start : a.line.start;
  const auto parts = [](const Segment& s, const Segment& t) {
    return orientation(s.start, s.end, t.start) * orientation(s.start, s.end, t.end) < 0;
  };
  if (!parts(a.line, b.line) || !parts(b.line, a.line)) return std::nullopt;
  return point_at(a.line, std::clamp(exact_station(a.line, b.line).value, 0.0, 1.0));
}

double mean_width(std::span<const Point> loop) {
  double around = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) around += distance(loop[i], loop[i + 1 == loop.size() ? 0 : i + 1]);
  return around > 0 ? 2 * std::fabs(area(loop)) / around : 0;
}

/// Whether a crossing is more than the rounding of coordinates.
bool is_wide(const std::vector<ChainEdge>& edges, std::size_t one, std::size_t other, Point at, double least) {
  const ChainEdge& a = edges[one];
  const ChainEdge& b = edges[other];
  if (a.name.loop != b.name.loop)
    return std::min({distance(a.line, b.line.start), distance(a.line, b.line.end), distance(b.line, a.line.start),
                     distance(b.line, a.line.end)}) > least;
  const auto part = [&](std::size_t from, std::size_t to) {
    std::vector<Point> loop{at};
    for (std::size_t k = from; k != to; k = edges[k].next) loop.push_back(edges[k].line.end);
    return mean_width(loop);
  };
  return std::min(part(one, other), part(other, one)) > least;
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

std::optional<EdgeCrossing> first_crossing(std::span<const std::vector<Point>> loops, double least) {
  const std::vector<ChainEdge> edges = chain_edges(loops);
  std::vector<Box> boxes(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    boxes[i].add(edges[i].line.start);
    boxes[i].add(edges[i].line.end);
  }
  std::optional<EdgeCrossing> found;
  visit_touching(boxes, 0, [&](int i, int j) {
    const auto one = static_cast<std::size_t>(i);
    const auto other = static_cast<std::size_t>(j);
    if (edges[one].next == other || edges[other].next == one) return true;
    const auto at = crossing_of(edges[one], edges[other]);
    if (at && is_wide(edges, one, other, *at, least)) found = EdgeCrossing{edges[one].name, edges[other].name, *at};
    return !found;
  });
  return found;
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
