// Finds meetings of pieces with each other and with the mesh; see overlay.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/covers/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "base/union_find.hpp"
#include "geometry/predicates.hpp"
#include "geometry/segment.hpp"
#include "problem/lines/segment_grid.hpp"

namespace keyblock {
namespace {

/// Units in the last place of the greatest coordinate: a node of a mesh and a crossing take a few roundings each.
constexpr double kRoundOffUnits = 16;

/// Error of floating-point stations above which crossings at a flat angle get exact ones.
constexpr double kRoughPlaceOnSide = 1e-14;

std::vector<MeshSide> sides_of(const TriangleMesh& mesh) {
  struct Half {
    int low, high, triangle;
    bool is_upward;  // from the lower-numbered node to the higher
  };
  std::vector<Half> halves;
  halves.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int from = mesh.triangles[t][k];
      const int to = mesh.triangles[t][(k + 1) % 3];
      halves.push_back({std::min(from, to), std::max(from, to), static_cast<int>(t), from < to});
    }
  }
  std::sort(halves.begin(), halves.end(), [](const Half& a, const Half& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  std::vector<MeshSide> sides;
  for (const Half& half : halves) {
    if (sides.empty() || sides.back().nodes != std::array{half.low, half.high})
      sides.push_back({{half.low, half.high}, -1, -1});
    (half.is_upward ? sides.back().left : sides.back().right) = half.triangle;
  }
  return sides;
}

double round_off_of(const BodyGraph& graph, const TriangleMesh& mesh) {
  double greatest = 0;
  for (const std::vector<Point>* points : {&graph.nodes, &mesh.nodes}) {
    for (const Point p : *points) greatest = std::max({greatest, std::fabs(p.x), std::fabs(p.y)});
  }
  return kRoundOffUnits * std::numeric_limits<double>::epsilon() * greatest;
}

/// Returns the nodes of the graph; those that are nodes of the mesh up to rounding are made equal to the bit.
std::vector<Point> nodes_on_mesh(const BodyGraph& graph, const TriangleMesh& mesh, double round_off) {
  std::vector<Segment> points;
  for (const Point p : mesh.nodes) points.push_back({p, p});
  SegmentGrid grid(points, round_off);
  std::vector<Point> nodes = graph.nodes;
  for (Point& node : nodes) {
    for (const int k : grid.near({node, node}, static_cast<int>(points.size()))) {
      if (distance(node, mesh.nodes[k]) <= round_off) node = mesh.nodes[k];
    }
  }
  return nodes;
}

/// Node strictly inside a segment. If two segments cross there, `other` is the second one, else -1.
struct StopOnSegment {
  Station station;
  int node = 0;
  int other = -1;
};

/// Holds pieces and sides as segments between numbered nodes: those of the graph, then of the mesh, then crossings.
class Overlaying {
 public:
  Overlaying(const BodyGraph& graph, const TriangleMesh& mesh, std::vector<MeshSide> sides)
      : piece_count_(static_cast<int>(graph.pieces.size())),
        sides_(std::move(sides)),
        round_off_(round_off_of(graph, mesh)),
        positions_(nodes_on_mesh(graph, mesh, round_off_)) {
    positions_.insert(positions_.end(), mesh.nodes.begin(), mesh.nodes.end());
    const int first_mesh_node = static_cast<int>(graph.nodes.size());
    for (const BodyPiece& piece : graph.pieces) add_segment(piece.from, piece.to);
    for (const MeshSide& side : sides_) add_segment(first_mesh_node + side.nodes[0], first_mesh_node + side.nodes[1]);
    stops_.resize(segments_.size());
  }

  Overlay run() {
    meet();
    unite_equal_stops();
    return finish();
  }

 private:
  void add_segment(int from, int to) {
    ends_.push_back({from, to});
    segments_.push_back({positions_[from], positions_[to]});
  }

  /// Meets pieces with pieces and sides only, because sides of the mesh meet each other in common nodes.
  void meet() {
    SegmentGrid grid(segments_, 0);
    const int count = static_cast<int>(segments_.size());
    for (int piece = 0; piece < piece_count_; ++piece) {
      if (has_no_length(piece)) {
        same_.push_back({ends_[piece][0], ends_[piece][1]});
        continue;
      }
      for (const int other : grid.near(segments_[piece], count)) {
        if (other > piece && !has_no_length(other)) meet(piece, other);
      }
    }
  }

  bool has_no_length(int segment) const { return segments_[segment].start == segments_[segment].end; }

  void meet(int a, int b) {
    switch (meeting(segments_[a], segments_[b])) {
      case Meeting::none:
        return;
      case Meeting::crossing:
        return cross(a, b);
      case Meeting::overlapping:
        for (const int node : ends_[b]) put_on(a, node);
        for (const int node : ends_[a]) put_on(b, node);
    }
  }

  /// Puts a node on a segment. The node must be on its straight line, but may lie beyond its ends.
  void put_on(int segment, int node) {
    const Point p = positions_[node];
    const Segment& s = segments_[segment];
    if (p == s.start) return same_.push_back({node, ends_[segment][0]});
    if (p == s.end) return same_.push_back({node, ends_[segment][1]});
    if (agreement(s.start, s.end, s.start, p) > 0 && agreement(s.start, s.end, p, s.end) > 0) add_stop(segment, node);
  }

  void cross(int a, int b) {
    const int on_b = end_on_carrier(a, b);
    const int on_a = end_on_carrier(b, a);
    if (on_a >= 0 && on_b >= 0) {
      same_.push_back({on_a, on_b});
    } else if (on_b >= 0) {
      add_stop(b, on_b);
    } else if (on_a >= 0) {
      add_stop(a, on_a);
    } else {
      add_crossing(a, b);
    }
  }

  /// Returns the end of `segment` on the straight line of `carrier`, or -1.
  int end_on_carrier(int segment, int carrier) const {
    const Segment& c = segments_[carrier];
    for (const int node : ends_[segment]) {
      if (orientation(c.start, c.end, positions_[node]) == 0) return node;
    }
    return -1;
  }

  void add_stop(int segment, int node) {
    stops_[segment].push_back({station(segments_[segment], {positions_[node], positions_[node]}), node, -1});
  }

  void add_crossing(int a, int b) {
    const int node = static_cast<int>(positions_.size());
    Station on_a = station(segments_[a], segments_[b]);
    if (!(on_a.error <= kRoughPlaceOnSide)) on_a = exact_station(segments_[a], segments_[b]);
    positions_.push_back(point_at(segments_[a], on_a.value));
    stops_[a].push_back({on_a, node, b});
    stops_[b].push_back({station(segments_[b], segments_[a]), node, a});
  }

  Segment mark(const StopOnSegment& stop) const {
    return stop.other >= 0 ? segments_[stop.other] : Segment{positions_[stop.node], positions_[stop.node]};
  }

  int compare(int segment, const StopOnSegment& a, const StopOnSegment& b) const {
    if (is_order_certain(a.station, b.station)) return a.station.value < b.station.value ? -1 : 1;
    return a.node == b.node ? 0 : compare_stations(segments_[segment], mark(a), mark(b));
  }

  void unite_equal_stops() {
    for (std::size_t k = 0; k < stops_.size(); ++k) {
      const int segment = static_cast<int>(k);
      std::vector<StopOnSegment>& stops = stops_[k];
      std::sort(stops.begin(), stops.end(), [&](const StopOnSegment& a, const StopOnSegment& b) {
        const int way = compare(segment, a, b);
        return way != 0 ? way < 0 : a.node < b.node;
      });
      for (std::size_t i = 1; i < stops.size(); ++i) {
        if (compare(segment, stops[i - 1], stops[i]) == 0) same_.push_back({stops[i - 1].node, stops[i].node});
      }
    }
  }

  Overlay finish() {
    UnionFind groups(positions_.size());
    for (const auto& [a, b] : same_) groups.unite(a, b);
    std::vector<int> number(positions_.size(), -1);
    Overlay result;
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      const int first = groups.find(static_cast<int>(i));  // the lowest: a given point before a crossing
      if (number[first] < 0) {
        number[first] = static_cast<int>(result.arrangement.nodes.size());
        result.arrangement.nodes.push_back({positions_[first], true});
      }
      number[i] = number[first];
    }
    add_edges(number, result);
    result.arrangement.lines = std::move(segments_);
    result.sides = std::move(sides_);
    result.round_off = round_off_;
    return result;
  }

  struct Part {
    int low, high, segment;
    bool is_reversed;  // from `high` to `low`
  };

  void add_edges(const std::vector<int>& number, Overlay& result) const {
    std::vector<Part> parts;
    for (std::size_t k = 0; k < segments_.size(); ++k) {
      int last = number[ends_[k][0]];
      const auto go_to = [&](int node) {
        if (node != last)
          parts.push_back({std::min(last, node), std::max(last, node), static_cast<int>(k), node < last});
        last = node;
      };
      for (const StopOnSegment& stop : stops_[k]) go_to(number[stop.node]);
      go_to(number[ends_[k][1]]);
    }
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
      return std::tie(a.low, a.high, a.segment) < std::tie(b.low, b.high, b.segment);
    });
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Part& part = parts[k];
      const bool is_new = k == 0 || parts[k - 1].low != part.low || parts[k - 1].high != part.high;
      if (is_new) add_edge(part, result);
      note_origin(part, result);
    }
  }

  void add_edge(const Part& part, Overlay& result) const {
    const auto [from, to] = part.is_reversed ? std::pair(part.high, part.low) : std::pair(part.low, part.high);
    result.arrangement.edges.push_back({from, to, part.segment, true});
    result.origins.emplace_back();
  }

  /// Records the first piece and the first side of an edge.
  void note_origin(const Part& part, Overlay& result) const {
    EdgeOrigin& origin = result.origins.back();
    const bool is_reversed = part.is_reversed != (result.arrangement.edges.back().from == part.high);
    if (part.segment < piece_count_ && origin.piece < 0) {
      origin.piece = part.segment;
      origin.piece_is_reversed = is_reversed;
    } else if (part.segment >= piece_count_ && origin.side < 0) {
      origin.side = part.segment - piece_count_;
      origin.side_is_reversed = is_reversed;
    }
  }

  int piece_count_;
  std::vector<MeshSide> sides_;
  double round_off_;
  std::vector<Point> positions_;
  std::vector<std::array<int, 2>> ends_;
  std::vector<Segment> segments_;
  std::vector<std::vector<StopOnSegment>> stops_;
  std::vector<std::pair<int, int>> same_;  // pairs of nodes that are one point
};

}  // namespace

Overlay overlay(const BodyGraph& graph, const TriangleMesh& mesh) {
  return Overlaying(graph, mesh, sides_of(mesh)).run();
}

}  // namespace keyblock
