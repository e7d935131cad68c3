// Computes measures of polygons; see polygon.hpp.
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

/// Edge with its neighbours in the chain; edges of zero length are left out.
struct ChainEdge {
  LoopEdge name;
  Segment line;
  std::size_t next = 0;
  std::size_t previous = 0;
};

std::vector<ChainEdge> chain_edges(std::span<const std::vector<Point>> loops) {
  std::vector<ChainEdge> edges;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const std::vector<Point>& loop = loops[l];
    const std::size_t first = edges.size();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Segment line{loop[i], loop[i + 1 == loop.size() ? 0 : i + 1]};
      if (line.start != line.end) edges.push_back({{l, i}, line, edges.size() + 1, 0});
    }
    if (edges.size() == first) continue;
    edges.back().next = first;
    for (std::size_t k = first; k < edges.size(); ++k) edges[edges[k].next].previous = k;
  }
  return edges;
}

/// Returns the side of a point relative to a chain p → at → n: 1 left, -1 right, 0 on it.
int side_of_chain(Point p, Point at, Point n, Point q) {
  const int first = orientation(p, at, q);
  const int second = orientation(at, n, q);
  const int bend = orientation(p, at, n);
  if (bend == 0 && agreement(p, at, at, n) < 0) return 0;  // there and back
  if (bend >= 0) return first > 0 && second > 0 ? 1 : first < 0 || second < 0 ? -1 : 0;
  return first > 0 || second > 0 ? 1 : first < 0 && second < 0 ? -1 : 0;
}

bool runs_along(const Segment& a, const Segment& b) {
  if (orientation(a.start, a.end, b.start) != 0 || orientation(a.start, a.end, b.end) != 0) return false;
  return agreement(a.start, a.end, b.start, b.end) > 0 && agreement(a.start, a.end, b.start, a.end) > 0 &&
         agreement(a.start, a.end, a.start, b.end) > 0;
}

/// Returns a common point of two edges, if they share no more than one point.
std::optional<Point> meeting_point(const Segment& a, const Segment& b) {
  if (meeting(a, b) != Meeting::crossing) return std::nullopt;
  for (const Point p : {a.start, a.end})
    if (orientation(b.start, b.end, p) == 0) return p;
  for (const Point p : {b.start, b.end})
    if (orientation(a.start, a.end, p) == 0) return p;
  return point_at(a, std::clamp(exact_station(a, b).value, 0.0, 1.0));
}

double mean_width(std::span<const Point> loop) {
  double around = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) around += distance(loop[i], loop[i + 1 == loop.size() ? 0 : i + 1]);
  return around > 0 ? 2 * std::fabs(area(loop)) / around : 0;
}

/// Chains with the crossings that exceed the rounding of coordinates.
class Chains {
 public:
  Chains(std::span<const std::vector<Point>> loops, double least) : edges_(chain_edges(loops)), least_(least) {}

  const std::vector<ChainEdge>& edges() const { return edges_; }
  bool are_neighbours(std::size_t a, std::size_t b) const { return edges_[a].next == b || edges_[b].next == a; }

  /// Returns the point in which two edges cross, or begin to run along each other in one direction.
  std::optional<Point> crossing(std::size_t one, std::size_t other) const {
    const Segment& a = edges_[one].line;
    const Segment& b = edges_[other].line;
    if (runs_along(a, b)) return agreement(a.start, a.end, a.start, b.start) > 0 ? b.start : a.start;
    const auto at = meeting_point(a, b);
    if (!at || !passes(one, other, *at)) return std::nullopt;
    const bool is_one_loop = edges_[one].name.loop == edges_[other].name.loop;
    if (is_one_loop && std::min(width_between(one, other, *at), width_between(other, one, *at)) <= least_)
      return std::nullopt;
    return at;
  }

 private:
  std::optional<Point> far_ahead(std::size_t from, Point at) const {
    for (std::size_t k = from;;) {
      if (distance(edges_[k].line.end, at) > least_) return edges_[k].line.end;
      k = edges_[k].next;
      if (k == from) return std::nullopt;
    }
  }

  std::optional<Point> far_behind(std::size_t from, Point at) const {
    for (std::size_t k = from;;) {
      if (distance(edges_[k].line.start, at) > least_) return edges_[k].line.start;
      k = edges_[k].previous;
      if (k == from) return std::nullopt;
    }
  }

  /// Returns true if a chain comes from one side of the other and leaves on the other side, seen from `least` away.
  bool passes(std::size_t one, std::size_t other, Point at) const {
    const auto from = far_behind(one, at), to = far_ahead(one, at);
    const auto before = far_behind(other, at), after = far_ahead(other, at);
    if (!from || !to || !before || !after) return false;
    return side_of_chain(*before, at, *after, *from) * side_of_chain(*before, at, *after, *to) < 0;
  }

  /// Returns the mean width of the part of a loop from the crossing along `from` and back along `to`.
  double width_between(std::size_t from, std::size_t to, Point at) const {
    std::vector<Point> loop{at};
    for (std::size_t k = from; k != to; k = edges_[k].next) loop.push_back(edges_[k].line.end);
    return mean_width(loop);
  }

  std::vector<ChainEdge> edges_;
  double least_;
};

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
  const Chains chains(loops, least);
  const std::vector<ChainEdge>& edges = chains.edges();
  std::vector<Box> boxes(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    boxes[i].add(edges[i].line.start);
    boxes[i].add(edges[i].line.end);
  }
  std::optional<EdgeCrossing> found;
  visit_touching(boxes, 0, [&](int i, int j) {
    const auto one = static_cast<std::size_t>(i);
    const auto other = static_cast<std::size_t>(j);
    if (chains.are_neighbours(one, other)) return true;
    if (const auto at = chains.crossing(one, other)) found = EdgeCrossing{edges[one].name, edges[other].name, *at};
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
