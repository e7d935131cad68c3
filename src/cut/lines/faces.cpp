// Traces faces by rotation around the nodes, and places holes by the edge below them; see faces.hpp. Half-edge 2e runs
// along edge e from `from` to `to`, half-edge 2e + 1 back. A walk is a closed sequence of half-edges with one face on
// its left. The walk around the outside of a connected part is its rim.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/lines/faces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "base/union_find.hpp"
#include "cut/lines/rotation.hpp"
#include "geometry/polygon.hpp"
#include "geometry/predicates.hpp"

namespace keyblock {
namespace {

/// All walks, one after the other.
struct Walks {
  std::vector<std::size_t> start;  // per walk, and one past the last
  std::vector<int> half_edges;
  std::vector<int> of_half_edge;

  int count() const { return static_cast<int>(start.size()) - 1; }
};

Walks trace_walks(const Arrangement& a, const RotationSystem& rotation) {
  Walks walks;
  walks.of_half_edge.assign(2 * a.edges.size(), -1);
  walks.half_edges.reserve(2 * a.edges.size());
  walks.start = {0};
  for (std::size_t node = 0; node < a.nodes.size(); ++node) {
    for (const int calling : rotation.leaving(static_cast<int>(node))) {
      const int first = rotation.next(twin(calling));
      if (walks.of_half_edge[first] >= 0) continue;
      for (int h = first; walks.of_half_edge[h] < 0; h = rotation.next(h)) {
        walks.of_half_edge[h] = walks.count();
        walks.half_edges.push_back(h);
      }
      walks.start.push_back(walks.half_edges.size());
    }
  }
  return walks;
}

double signed_area(const Arrangement& a, const Chain& chain) {
  std::vector<Point> points;
  for (const ChainLink& link : chain) points.push_back(a.nodes[link.node].position);
  return area(points);
}

/// Cuts walks at nodes that they pass more than once.
class ChainCutter {
 public:
  explicit ChainCutter(const Arrangement& a) : a_(a), position_(a.nodes.size(), -1) {}

  std::vector<Chain> cut(const Walks& walks, int walk) {
    // Two loops through one node have at least three edges each.
    constexpr std::size_t kShortestWithTwoVisits = 6;
    const bool is_plain = walks.start[walk + 1] - walks.start[walk] < kShortestWithTwoVisits;
    std::vector<Chain> chains;
    if (is_plain) {
      chains.push_back(whole(walks, walk));
    } else {
      chains = split(walks, walk);
    }
    for (Chain& chain : chains) start_at_lowest(chain);
    return chains;
  }

 private:
  Chain whole(const Walks& walks, int walk) const {
    Chain chain;
    chain.reserve(walks.start[walk + 1] - walks.start[walk]);
    for (std::size_t k = walks.start[walk]; k < walks.start[walk + 1]; ++k) {
      const int h = walks.half_edges[k];
      chain.push_back({head(a_, h), a_.edges[h / 2].line, h});
    }
    return chain;
  }

  std::vector<Chain> split(const Walks& walks, int walk) {
    std::vector<Chain> chains;
    Chain open;
    for (std::size_t k = walks.start[walk]; k < walks.start[walk + 1]; ++k) {
      const int h = walks.half_edges[k];
      ChainLink link{head(a_, h), a_.edges[h / 2].line, h};
      if (position_[link.node] >= 0) {
        chains.push_back(take_loop(open, link.node));
        // The arriving edge closes the loop; the edge that arrived first closes the remainder.
        std::swap(chains.back().front(), link);
      }
      position_[link.node] = static_cast<int>(open.size());
      open.push_back(link);
    }
    for (const ChainLink& link : open) position_[link.node] = -1;
    chains.push_back(std::move(open));
    return chains;
  }

  Chain take_loop(Chain& open, int node) {
    const auto begin = open.begin() + position_[node];
    Chain loop(begin, open.end());
    open.erase(begin, open.end());
    for (const ChainLink& link : loop) position_[link.node] = -1;
    return loop;
  }

  static void start_at_lowest(Chain& chain) {
    const auto is_lower = [](const ChainLink& x, const ChainLink& y) { return x.node < y.node; };
    std::rotate(chain.begin(), std::min_element(chain.begin(), chain.end(), is_lower), chain.end());
  }

  const Arrangement& a_;
  std::vector<int> position_;  // per node: place in the open chain
};

/// Walk around the outside of each connected part, with the part's leftmost (then lowest) node.
struct Rim {
  int walk = 0;
  int node = 0;
};

bool is_left_of(Point a, Point b) {
  return std::tie(a.x, a.y) < std::tie(b.x, b.y);
}

/// Returns the edge leaving a leftmost node that turns farthest counter-clockwise: it has the outside on its left.
int outermost(const Arrangement& a, std::span<const int> leaving) {
  int best = leaving.front();
  for (const int h : leaving) {
    const Segment from = direction(a, best);
    const Segment to = direction(a, h);
    const int by_lines = turn(from.start, from.end, to.start, to.end);
    // Parallel lines that end in one node by merging are separated by the ends of their edges.
    const int by_ends = by_lines != 0 ? by_lines
                                      : orientation(a.nodes[tail(a, h)].position, a.nodes[head(a, best)].position,
                                                    a.nodes[head(a, h)].position);
    if (by_ends > 0) best = h;
  }
  return best;
}

std::vector<Rim> find_rims(const Arrangement& a, const RotationSystem& rotation, const Walks& walks) {
  UnionFind parts(a.nodes.size());
  for (const Edge& e : a.edges) parts.unite(e.from, e.to);
  std::vector<int> leftmost(a.nodes.size(), -1);
  for (std::size_t n = 0; n < a.nodes.size(); ++n) {
    const int node = static_cast<int>(n);
    if (rotation.leaving(node).empty()) continue;
    int& best = leftmost[parts.find(node)];
    if (best < 0 || is_left_of(a.nodes[node].position, a.nodes[best].position)) best = node;
  }
  std::vector<Rim> rims;
  for (const int node : leftmost) {
    if (node < 0) continue;
    rims.push_back({walks.of_half_edge[outermost(a, rotation.leaving(node))], node});
  }
  return rims;
}

/// Returns an edge from its left to its right end.
Segment rightward(const Arrangement& a, const Edge& e) {
  const Point p = a.nodes[e.from].position;
  const Point q = a.nodes[e.to].position;
  return is_left_of(p, q) ? Segment{p, q} : Segment{q, p};
}

/// Compares two pieces over a common x that do not cross.
bool is_above(const Segment& a, const Segment& b) {
  if (a.start.x < b.start.x) return !is_above(b, a);
  const int start = orientation(b.start, b.end, a.start);
  return start != 0 ? start > 0 : orientation(b.start, b.end, a.end) > 0;
}

/// Returns, per rim, the half-edge nearest below its leftmost node, with that node on its left; -1 if nothing lies
/// below. `rims` must be ordered from left to right.
std::vector<int> half_edges_below(const Arrangement& a, const std::vector<Rim>& rims) {
  std::vector<int> nearest(rims.size(), -1);
  const auto x_of = [&](const Rim& rim) { return a.nodes[rim.node].position.x; };
  for (std::size_t e = 0; e < a.edges.size(); ++e) {
    const Segment s = rightward(a, a.edges[e]);
    auto rim =
        std::lower_bound(rims.begin(), rims.end(), s.start.x, [&](const Rim& r, double x) { return x_of(r) < x; });
    for (; rim != rims.end() && x_of(*rim) < s.end.x; ++rim) {
      if (orientation(s.start, s.end, a.nodes[rim->node].position) <= 0) continue;
      int& best = nearest[static_cast<std::size_t>(rim - rims.begin())];
      if (best >= 0 && !is_above(s, rightward(a, a.edges[best / 2]))) continue;
      const bool runs_right = s.start == a.nodes[a.edges[e].from].position;
      best = static_cast<int>(2 * e) + (runs_right ? 0 : 1);
    }
  }
  return nearest;
}

// Surroundings of walks without a bounded walk around them, and of walks that are no rims.
constexpr int kOpenPlane = -1;
constexpr int kNotARim = -2;

/// Returns, per walk that is the rim of a part, the bounded walk around it, or kOpenPlane.
std::vector<int> find_surroundings(const Arrangement& a, const Walks& walks, std::vector<Rim> rims) {
  std::vector<int> around(walks.count(), kNotARim);
  for (const Rim& rim : rims) around[rim.walk] = kOpenPlane;
  if (rims.size() < 2) return around;
  // The rim found below belongs to a part that begins farther left, so parts are visited from left to right.
  std::sort(rims.begin(), rims.end(),
            [&](const Rim& x, const Rim& y) { return is_left_of(a.nodes[x.node].position, a.nodes[y.node].position); });
  const std::vector<int> below = half_edges_below(a, rims);
  for (std::size_t i = 0; i < rims.size(); ++i) {
    if (below[i] < 0) continue;
    const int walk = walks.of_half_edge[below[i]];
    around[rims[i].walk] = around[walk] == kNotARim ? walk : around[walk];
  }
  return around;
}

Face bounded_face(const Arrangement& a, std::vector<Chain> chains) {
  std::size_t outer = 0;
  if (chains.size() > 1) {
    const auto is_smaller = [&](const Chain& x, const Chain& y) { return signed_area(a, x) < signed_area(a, y); };
    outer = std::max_element(chains.begin(), chains.end(), is_smaller) - chains.begin();
  }
  Face face{std::move(chains[outer]), {}};
  chains.erase(chains.begin() + static_cast<std::ptrdiff_t>(outer));
  face.holes = std::move(chains);
  return face;
}

}  // namespace

std::vector<Face> trace_faces(const Arrangement& a) {
  const RotationSystem rotation(a);
  const Walks walks = trace_walks(a, rotation);
  const std::vector<int> around = find_surroundings(a, walks, find_rims(a, rotation, walks));
  ChainCutter cutter(a);
  std::vector<Face> faces;
  std::vector<int> face_of_walk(walks.count(), -1);
  for (int walk = 0; walk < walks.count(); ++walk) {
    if (around[walk] != kNotARim) continue;
    face_of_walk[walk] = static_cast<int>(faces.size());
    faces.push_back(bounded_face(a, cutter.cut(walks, walk)));
  }
  for (int walk = 0; walk < walks.count(); ++walk) {
    if (around[walk] < 0) continue;
    for (Chain& chain : cutter.cut(walks, walk)) {
      faces[face_of_walk[around[walk]]].holes.push_back(std::move(chain));
    }
  }
  return faces;
}

}  // namespace keyblock
