// Separating edge of each pair, then the ends of the common stretch.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/touch.hpp"

#include <algorithm>
#include <limits>

namespace keyblock {
namespace {

// Two separations that differ by less than this share of the edge are equal up to round-off: the first one found stays, so
// that parallel faces do not change their line of reference from step to step.
constexpr double kTie = 1e-9;

struct Edge {
  VertexIndex start;
  VertexIndex end;
  bool is_inner = false;
};

class PairTouches {
 public:
  PairTouches(const ConvexPiece& a, const ConvexPiece& b, const Table<VertexIndex, Point>& vertices, double reach)
      : vertices_(vertices), reach_(reach) {
    const Reference of_a = best_edge(a, b);
    const Reference of_b = best_edge(b, a);
    const bool a_leads = of_a.separation >= of_b.separation - kTie * length(along(of_b.edge));
    reference_ = a_leads ? of_a : of_b;
    other_ = a_leads ? &b : &a;
  }

  Touches run() const {
    if (reference_.separation > reach_ || reference_.edge.is_inner) return {};
    const Edge facing = most_opposed();
    if (facing.is_inner) return {};
    // Stretch along the line of reference: that of the line itself, and the facing edge, which runs against it.
    const double own_low = 0;
    const double own_high = length(along(reference_.edge));
    const double facing_low = station(facing.end);
    const double facing_high = station(facing.start);
    if (std::min(own_high, facing_high) < std::max(own_low, facing_low) - kTie * own_high) return {};
    Touches touches;
    touches.push_back(facing_low >= own_low ? on_reference(facing.end) : on_facing(reference_.edge.start, facing));
    touches.push_back(facing_high <= own_high ? on_reference(facing.start) : on_facing(reference_.edge.end, facing));
    return touches;
  }

 private:
  struct Reference {
    Edge edge;
    double separation = -std::numeric_limits<double>::infinity();
  };

  Point at(VertexIndex v) const { return vertices_[v]; }
  Point along(Edge e) const { return at(e.end) - at(e.start); }
  static Edge edge_of(const ConvexPiece& piece, std::size_t i) {
    return {piece.corners[i], piece.corners[i + 1 == piece.corners.size() ? 0 : i + 1], piece.is_inner[i]};
  }

  double separation(Edge edge, const ConvexPiece& from) const {
    const Point direction = (1 / length(along(edge))) * along(edge);
    double least = std::numeric_limits<double>::infinity();
    for (VertexIndex v : from.corners) least = std::min(least, -cross(direction, at(v) - at(edge.start)));
    return least;
  }

  // An inner edge leads only if it leads clearly: it may lie on one line with an edge of the boundary.
  Reference best_edge(const ConvexPiece& of, const ConvexPiece& from) const {
    Reference best;
    for (std::size_t i = 0; i < of.corners.size(); ++i) {
      const Edge edge = edge_of(of, i);
      const double value = separation(edge, from);
      const double tie = kTie * length(along(edge));
      const bool leads = value > best.separation + tie;
      const bool replaces_inner = best.edge.is_inner && !edge.is_inner && value >= best.separation - tie;
      if (i == 0 || leads || replaces_inner) best = {edge, value};
    }
    return best;
  }

  Edge most_opposed() const {
    const Point direction = along(reference_.edge);
    Edge best = edge_of(*other_, 0);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < other_->corners.size(); ++i) {
      const Edge edge = edge_of(*other_, i);
      const double cosine = dot(along(edge), direction) / length(along(edge));
      if (cosine < least - kTie * length(direction)) {
        least = cosine;
        best = edge;
      }
    }
    return best;
  }

  double station(VertexIndex v) const {
    const Point line = along(reference_.edge);
    return dot(at(v) - at(reference_.edge.start), line) / length(line);
  }

  Touch on_reference(VertexIndex v) const { return {v, reference_.edge.start, reference_.edge.end}; }
  static Touch on_facing(VertexIndex v, Edge facing) { return {v, facing.start, facing.end}; }

  const Table<VertexIndex, Point>& vertices_;
  double reach_;
  Reference reference_;
  const ConvexPiece* other_ = nullptr;
};

}  // namespace

Touches find_touches(const std::vector<ElementPair>& pairs, const Table<ElementIndex, ConvexPieces>& pieces,
                     const Table<VertexIndex, Point>& vertices, double reach) {
  Touches touches;
  for (const auto& [a, b] : pairs) {
    Touches of_pair;
    for (const ConvexPiece& of_a : pieces[a]) {
      for (const ConvexPiece& of_b : pieces[b]) {
        const Touches found = PairTouches(of_a, of_b, vertices, reach).run();
        of_pair.insert(of_pair.end(), found.begin(), found.end());
      }
    }
    // Pieces of one element share corners.
    std::ranges::sort(of_pair);
    const auto repeated = std::ranges::unique(of_pair);
    touches.insert(touches.end(), of_pair.begin(), repeated.begin());
  }
  return touches;
}

}  // namespace keyblock
