// Makes detours and crossings of moved pieces; see planarize.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/lines/planarize.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "geometry/predicates.hpp"
#include "geometry/segment.hpp"
#include "problem/lines/segment_grid.hpp"

namespace keyblock {
namespace {

/// Bound on the iterations, which only guarantees an end. A node put on a crossing may lie beside a further piece,
/// whose detour may cross another.
constexpr int kMaxRounds = 20;
/// Bound on the nodes, per nodes at the beginning; drawings that can be cut get few more.
constexpr std::size_t kMostGrowth = 4;
constexpr std::size_t kFewNodes = 100;

Segment segment_of(const Arrangement& a, const Edge& e) {
  return {a.nodes[e.from].position, a.nodes[e.to].position};
}

std::vector<Segment> segments_of(const Arrangement& a) {
  std::vector<Segment> result;
  for (const Edge& e : a.edges) result.push_back(segment_of(a, e));
  return result;
}

/// Keeps one piece per pair of nodes, that of the lowest-numbered line.
void drop_doubles(std::vector<Edge>& edges) {
  const auto ends = [](const Edge& e) { return std::pair(std::min(e.from, e.to), std::max(e.from, e.to)); };
  std::sort(edges.begin(), edges.end(),
            [&](const Edge& a, const Edge& b) { return std::tuple(ends(a), a.line) < std::tuple(ends(b), b.line); });
  edges.erase(std::unique(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) { return ends(a) == ends(b); }),
              edges.end());
}

/// Node on an edge, and its place.
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

/// Holds the nodes in use as points of a grid.
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

/// Leads pieces through the nodes beside them; a detour that passes a further node makes a detour of its own.
class Detours {
 public:
  Detours(Planarized& p, std::size_t boundary_count, const CutTolerances& tolerances)
      : p_(p),
        boundary_count_(static_cast<int>(boundary_count)),
        tolerances_(tolerances),
        nodes_(p.arrangement, tolerances.near_pass) {}

  void make() {
    const std::size_t before = p_.detours.size();
    for (const Edge& edge : p_.arrangement.edges) settle(edge);
    if (p_.detours.size() == before) return;
    drop_doubles(edges_);
    p_.arrangement.edges = std::move(edges_);
  }

 private:
  /// Leads all parts of the piece through the nodes beside them, iteration by iteration. No part turns back to a node
  /// that any part passed before. Parts with the same ends are one, so there are no more parts than pairs of nodes.
  void settle(const Edge& edge) {
    const double reach = edge.line < boundary_count_ ? tolerances_.round_off : tolerances_.near_pass;
    std::set<int> passed{edge.from, edge.to};
    for (std::vector<Edge> parts{edge}; !parts.empty();) {
      std::vector<Edge> next;
      std::vector<int> met;
      for (const Edge& part : parts) {
        std::vector<Via> vias = nodes_.beside(p_.arrangement, part, reach);
        std::erase_if(vias, [&](const Via& via) { return passed.contains(via.node); });
        if (vias.empty()) {
          edges_.push_back(part);
          continue;
        }
        const Segment piece = segment_of(p_.arrangement, part);
        for (const Via& via : vias) {
          p_.detours.push_back({part.line, via.node, point_at(piece, via.t)});
          met.push_back(via.node);
        }
        add_chain(next, part, std::move(vias));
      }
      passed.insert(met.begin(), met.end());
      drop_doubles(next);
      parts = std::move(next);
    }
  }

  Planarized& p_;
  int boundary_count_;
  const CutTolerances& tolerances_;
  NodeGrid nodes_;
  std::vector<Edge> edges_;
};

/// Returns true if two pieces cross away from common nodes; pieces still on their lines never do.
bool cross_each_other(const Arrangement& a, const Edge& e, const Edge& f) {
  if (e.is_on_line && f.is_on_line) return false;
  if (e.from == f.from || e.from == f.to || e.to == f.from || e.to == f.to) return false;
  return meeting(segment_of(a, e), segment_of(a, f)) == Meeting::crossing;
}

/// Returns the place of a crossing on the piece, from 0 to 1. The quotient may be NaN for nearly parallel pieces, which
/// then use exact arithmetic.
double place_of_crossing(const Segment& piece, const Segment& other) {
  Station place = station(piece, other);
  if (!std::isfinite(place.value) || !std::isfinite(place.error)) place = exact_station(piece, other);
  return std::clamp(place.value, 0.0, 1.0);
}

/// Splits pieces that cross, once over all pairs; returns true if there were any.
bool split_crossings(Planarized& p) {
  Arrangement& a = p.arrangement;
  if (std::all_of(a.edges.begin(), a.edges.end(), [](const Edge& e) { return e.is_on_line; })) return false;
  const std::vector<Segment> pieces = segments_of(a);
  SegmentGrid grid(pieces, 0);
  std::vector<std::vector<Via>> vias(a.edges.size());
  const std::size_t before = a.nodes.size();
  for (int i = 0; i < static_cast<int>(a.edges.size()); ++i) {
    if (a.edges[i].is_on_line) continue;
    for (const int j : grid.near(pieces[i], static_cast<int>(pieces.size()))) {
      const bool is_second_look = j <= i && !a.edges[j].is_on_line;
      if (is_second_look || !cross_each_other(a, a.edges[i], a.edges[j])) continue;
      const double t = place_of_crossing(pieces[i], pieces[j]);
      const int node = static_cast<int>(a.nodes.size());
      a.nodes.push_back({point_at(pieces[i], t), false});
      vias[i].push_back({t, node});
      vias[j].push_back({place_of_crossing(pieces[j], pieces[i]), node});
    }
  }
  if (a.nodes.size() == before) return false;
  p.crossings += static_cast<int>(a.nodes.size() - before);
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < vias.size(); ++i) add_chain(edges, a.edges[i], std::move(vias[i]));
  drop_doubles(edges);
  a.edges = std::move(edges);
  return true;
}

}  // namespace

namespace {

// Deletes the piece of the later line if two pieces cross; boundaries stay (legacy-formats 3.6, step 4).
Planarized without_near_pieces(Arrangement arrangement, std::size_t boundary_count, const CutTolerances& tolerances) {
  Planarized result{std::move(arrangement), {}, 0, {}, true};
  Arrangement& a = result.arrangement;
  const auto is_boundary = [&](const Edge& e) { return e.line < static_cast<int>(boundary_count); };
  std::vector<char> goes(a.edges.size(), 0);
  const std::vector<Segment> pieces = segments_of(a);
  SegmentGrid grid(pieces, 0);
  for (int i = 0; i < static_cast<int>(a.edges.size()); ++i) {
    if (a.edges[i].is_on_line || goes[i]) continue;
    for (const int j : grid.near(pieces[i], static_cast<int>(pieces.size()))) {
      if (goes[i] || goes[j] || !cross_each_other(a, a.edges[i], a.edges[j])) continue;
      const bool i_goes = is_boundary(a.edges[j]) || (!is_boundary(a.edges[i]) && a.edges[i].line > a.edges[j].line);
      goes[i_goes ? i : j] = 1;
    }
  }
  NodeGrid nodes(a, tolerances.near_pass);
  for (std::size_t i = 0; i < a.edges.size(); ++i)
    if (!is_boundary(a.edges[i]) && !nodes.beside(a, a.edges[i], tolerances.near_pass).empty()) goes[i] = 1;
  std::vector<Edge> kept;
  for (std::size_t i = 0; i < a.edges.size(); ++i) (goes[i] ? result.deleted : kept).push_back(a.edges[i]);
  a.edges = std::move(kept);
  return result;
}

}  // namespace

Planarized planarize(Arrangement arrangement, std::size_t boundary_count, const CutTolerances& tolerances,
                     NearPieces near_pieces) {
  if (near_pieces == NearPieces::deleted)
    return without_near_pieces(std::move(arrangement), boundary_count, tolerances);
  Planarized result{std::move(arrangement), {}, 0, {}, true};
  const std::size_t most = kMostGrowth * result.arrangement.nodes.size() + kFewNodes;
  for (int round = 0; round < kMaxRounds; ++round) {
    Detours(result, boundary_count, tolerances).make();
    if (!split_crossings(result)) break;
    result.is_settled = result.arrangement.nodes.size() <= most;
    if (!result.is_settled) break;
  }
  return result;
}

}  // namespace keyblock
