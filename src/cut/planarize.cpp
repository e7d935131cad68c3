// Detours and crossings of moved pieces; see planarize.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/planarize.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "cut/segment_grid.hpp"
#include "geometry/predicates.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

/// A detour may lead past a further node, a new node may lie on a further piece. Nodes stand at least the
/// merging distance apart, so this ends after few rounds; the bound only guards against nodes that could not
/// be merged.
constexpr int kMaxRounds = 20;

Segment segment_of(const Arrangement& a, const Edge& e) {
  return {a.nodes[e.from].position, a.nodes[e.to].position};
}

std::vector<Segment> segments_of(const Arrangement& a) {
  std::vector<Segment> result;
  for (const Edge& e : a.edges) result.push_back(segment_of(a, e));
  return result;
}

/// One piece for each pair of nodes: the lowest-numbered line's.
void drop_doubles(std::vector<Edge>& edges) {
  const auto ends = [](const Edge& e) { return std::pair(std::min(e.from, e.to), std::max(e.from, e.to)); };
  std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) {
    return std::tuple(ends(a), a.line) < std::tuple(ends(b), b.line);
  });
  edges.erase(std::unique(edges.begin(), edges.end(),
                          [&](const Edge& a, const Edge& b) { return ends(a) == ends(b); }),
              edges.end());
}

/// A node on the way of an edge, and where.
struct Via {
  double t = 0;
  int node = 0;
};

/// Replaces the edge by the chain through the given nodes.
void add_chain(std::vector<Edge>& edges, const Edge& edge, std::vector<Via> vias) {
  std::sort(vias.begin(), vias.end(),
            [](const Via& a, const Via& b) { return std::tie(a.t, a.node) < std::tie(b.t, b.node); });
  int last = edge.from;
  for (const Via& via : vias) {
    if (via.node != last) edges.push_back({last, via.node, edge.line, false});
    last = via.node;
  }
  if (edge.to != last) edges.push_back({last, edge.to, edge.line, vias.empty() && edge.is_on_line});
}

/// Nodes in use, as points of a grid.
class NodeGrid {
 public:
  NodeGrid(const Arrangement& a, double reach) : points_(used_nodes(a)), grid_(points_, reach) {}

  std::vector<Via> beside(const Arrangement& a, const Edge& e, double reach) {
    std::vector<Via> vias;
    const Segment piece = segment_of(a, e);
    for (const int k : grid_.near(piece, static_cast<int>(points_.size()))) {
      const int node = nodes_[k];
      if (node == e.from || node == e.to) continue;
      const Point p = a.nodes[node].position;
      const double t = foot(piece, p);
      if (t > 0 && t < 1 && distance(point_at(piece, t), p) <= reach) vias.push_back({t, node});
    }
    return vias;
  }

 private:
  std::vector<Segment> used_nodes(const Arrangement& a) {
    for (const Edge& e : a.edges) nodes_.insert(nodes_.end(), {e.from, e.to});
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    std::vector<Segment> points;
    for (const int n : nodes_) points.push_back({a.nodes[n].position, a.nodes[n].position});
    return points;
  }

  std::vector<int> nodes_;
  std::vector<Segment> points_;
  SegmentGrid grid_;
};

/// One round of detours; says whether there were any.
bool make_detours(Planarized& p, std::size_t boundary_count, const CutTolerances& tolerances) {
  Arrangement& a = p.arrangement;
  NodeGrid nodes(a, tolerances.near_pass);
  std::vector<Edge> edges;
  bool has_changed = false;
  for (const Edge& edge : a.edges) {
    const bool is_boundary = edge.line < static_cast<int>(boundary_count);
    std::vector<Via> vias = nodes.beside(a, edge, is_boundary ? tolerances.round_off : tolerances.near_pass);
    for (const Via& via : vias)
      p.detours.push_back({edge.line, via.node, point_at(segment_of(a, edge), via.t)});
    has_changed |= !vias.empty();
    add_chain(edges, edge, std::move(vias));
  }
  drop_doubles(edges);
  a.edges = std::move(edges);
  return has_changed;
}

/// One round of crossings; says whether there were any.
bool split_crossings(Planarized& p) {
  Arrangement& a = p.arrangement;
  const std::vector<Segment> pieces = segments_of(a);
  SegmentGrid grid(pieces, 0);
  std::vector<std::vector<Via>> vias(a.edges.size());
  bool has_changed = false;
  for (int i = 0; i < static_cast<int>(a.edges.size()); ++i) {
    for (const int j : grid.near(pieces[i], i)) {
      const Edge& e = a.edges[i];
      const Edge& f = a.edges[j];
      if (e.is_on_line && f.is_on_line) continue;
      if (e.from == f.from || e.from == f.to || e.to == f.from || e.to == f.to) continue;
      if (meeting(pieces[i], pieces[j]) != Meeting::crossing) continue;
      const double t = station(pieces[i], pieces[j]).value;
      const int node = static_cast<int>(a.nodes.size());
      a.nodes.push_back({point_at(pieces[i], t), false});
      vias[i].push_back({t, node});
      vias[j].push_back({station(pieces[j], pieces[i]).value, node});
      ++p.crossings;
      has_changed = true;
    }
  }
  if (!has_changed) return false;
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < vias.size(); ++i) add_chain(edges, a.edges[i], std::move(vias[i]));
  drop_doubles(edges);
  a.edges = std::move(edges);
  return true;
}

}  // namespace

Planarized planarize(Arrangement arrangement, std::size_t boundary_count, const CutTolerances& tolerances) {
  Planarized result{std::move(arrangement), {}, 0};
  for (int round = 0; round < kMaxRounds; ++round) {
    if (make_detours(result, boundary_count, tolerances)) continue;
    if (!split_crossings(result)) break;
  }
  return result;
}

}  // namespace keyblock
