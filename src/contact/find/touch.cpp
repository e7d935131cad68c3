// Separating edge of each pair, then the ends of the common stretch; corners where no edge leads are put aside.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/find/touch.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "base/loop.hpp"

namespace keyblock {
namespace {

// Two separations that differ by less than this share of the edge are equal up to round-off: the first one found stays,
// so that parallel faces do not change their line of reference from step to step.
constexpr double kTie = 1e-9;
// Sine of the angle between two edges below which they count as parallel: half the turn of a corner that is one to the
// eye.
constexpr double kParallel = 1e-4;
// Lobatto's weights on three points are exact for cubics (Abramowitz & Stegun 1964, 25.4.32), so that springs on them
// turn as stiffly as an evenly sprung stretch, k L²/12, where two at the ends are three times as stiff; the end point
// is the pivot.
constexpr double kLobattoEnd = 1.0 / 6;

// Corners meet that are no farther apart than this many times what separates the pieces or counts as none: those of an
// exterior angle of thirty degrees. Faces that lean a little towards each other are as far apart at many places, but
// not corner to corner.
constexpr double kNearCorner = 4;

// Sine of the angle between two edges that face each other over a stretch below which they close like a wedge: the far
// end is what meets next, and either normal serves.
constexpr double kWedge = 0.1;

// A foot this share of the edge beyond its end lies at the end.
constexpr double kAtEnd = 1e-9;

struct Edge {
  VertexIndex start;
  VertexIndex end;
  bool is_inner = false;
};

struct Leading {
  Edge edge;
  double separation = -std::numeric_limits<double>::infinity();
};

Touch against(Edge e, VertexIndex vertex, VertexIndex met) {
  Touch touch{vertex, e.start, e.end};
  touch.other = met;
  return touch;
}

Touch bisector(const Touch& first, const Touch& second, bool of_two_elements) {
  Touch touch = first;
  touch.kind = TouchKind::bisector;
  touch.second_start = second.start;
  touch.second_end = second.end;
  touch.second_sign = of_two_elements ? -1 : 1;
  return touch;
}

// The two edges run against each other: low on one is high on the other.
Facing facing_of(Edge reference, Edge facing, int place) {
  if (reference.start < facing.start) return {reference.start, facing.start, place};
  return {facing.start, reference.start, 2 - place};
}

class PairTouches {
 public:
  PairTouches(const ConvexPiece& a, const ConvexPiece& b, const Table<VertexIndex, Point>& vertices,
              const TouchSearch& search, double slack)
      : vertices_(vertices),
        search_(search),
        slack_(slack),
        a_(a),
        b_(b),
        of_a_(best_edge(a, b)),
        of_b_(best_edge(b, a)) {
    a_leads_ = of_a_.separation >= of_b_.separation - kTie * length(along(of_b_.edge));
  }

  void add_to(FoundTouches& found, double rounding) const {
    const Leading& reference = a_leads_ ? of_a_ : of_b_;
    if (reference.separation > search_.reach || reference.edge.is_inner) return;
    const Edge facing = most_opposed(reference.edge, a_leads_ ? b_ : a_);
    CornerTie tie = tie_between(reference, facing);
    if (!tie.candidates.empty()) {
      found.ties.push_back(std::move(tie));
      return;
    }
    Touches touches = along_stretch(reference.edge, facing);
    if (rounding > 0) tie = rounded_by(rounding).tie_between(reference, facing);
    if (!tie.candidates.empty()) {
      tie.rounding = slack_ + rounding;
      tie.sharp = std::move(touches);
      found.ties.push_back(std::move(tie));
    } else {
      found.touches.insert(found.touches.end(), touches.begin(), touches.end());
    }
  }

 private:
  PairTouches rounded_by(double rounding) const {
    PairTouches rounded = *this;
    rounded.slack_ += rounding;
    return rounded;
  }

  // Without candidates where an edge leads.
  CornerTie tie_between(const Leading& reference, Edge facing) const {
    if (!corners_meet(reference) || is_wedge(reference, facing)) return {};
    CornerTie tie = tie_of(leading(a_, b_, reference.separation), leading(b_, a_, reference.separation));
    if (tie.candidates.empty() && only_ends_meet(reference, facing)) tie = tie_at_corners();
    return tie;
  }

  Point at(VertexIndex v) const { return vertices_[v]; }
  Point along(Edge e) const { return at(e.end) - at(e.start); }
  Point direction(Edge e) const { return (1 / length(along(e))) * along(e); }
  static Edge edge_of(const ConvexPiece& piece, std::size_t i) {
    return {piece.corners[i], piece.corners[i + 1 == piece.corners.size() ? 0 : i + 1], piece.is_inner[i]};
  }

  double separation(Edge edge, const ConvexPiece& from) const {
    const Point d = direction(edge);
    double least = std::numeric_limits<double>::infinity();
    for (VertexIndex v : from.corners) least = std::min(least, -cross(d, at(v) - at(edge.start)));
    return least;
  }

  // Whether the other piece lies over the edge, at least in part, and not over its line alone.
  bool is_over(Edge edge, const ConvexPiece& other) const {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (VertexIndex v : other.corners) {
      low = std::min(low, station(edge, v));
      high = std::max(high, station(edge, v));
    }
    return low <= length(along(edge)) && high >= 0;
  }

  // An inner edge leads only if it leads clearly: it may lie on one line with an edge of the boundary. Of two edges of
  // the boundary on one line that leads over which the other piece lies.
  Leading best_edge(const ConvexPiece& of, const ConvexPiece& from) const {
    Leading best;
    for (std::size_t i = 0; i < of.corners.size(); ++i) {
      const Edge edge = edge_of(of, i);
      const double value = separation(edge, from);
      const double tie = kTie * length(along(edge));
      const bool leads = value > best.separation + tie;
      const bool ties = i > 0 && !edge.is_inner && value >= best.separation - tie;
      const bool replaces = ties && (best.edge.is_inner || (!is_over(best.edge, from) && is_over(edge, from)));
      if (i == 0 || leads || replaces) best = {edge, value};
    }
    return best;
  }

  // Edges of either piece that lead as well as the best, if two of them are not parallel.
  CornerTie tie_of(const std::vector<Edge>& of_a, const std::vector<Edge>& of_b) const {
    if (of_a.size() + of_b.size() < 2) return {};
    const auto [p, q] = nearest_corners();
    CornerTie tie;
    for (const Edge& e : of_a) tie.candidates.push_back(against(e, q, p));
    for (const Edge& e : of_b) tie.candidates.push_back(against(e, p, q));
    Touches bisectors;
    for (std::size_t i = 0; i < tie.candidates.size(); ++i)
      for (std::size_t j = i + 1; j < tie.candidates.size(); ++j)
        if (!parallel(tie.candidates[i], tie.candidates[j]))
          bisectors.push_back(bisector(tie.candidates[i], tie.candidates[j], i < of_a.size() && j >= of_a.size()));
    if (bisectors.empty()) return {};
    tie.candidates.insert(tie.candidates.end(), bisectors.begin(), bisectors.end());
    return tie;
  }

  // Faces whose ends are in line may pass each other: a block that slides along the tops of a row of blocks comes up to
  // the end face of each, which it will not hit.
  CornerTie tie_at_corners() const {
    const auto [p, q] = nearest_corners();
    return tie_of(edges_at(p, a_), edges_at(q, b_));
  }

  static std::vector<Edge> edges_at(VertexIndex corner, const ConvexPiece& of) {
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < of.corners.size(); ++i) {
      const Edge edge = edge_of(of, i);
      if (!edge.is_inner && (edge.start == corner || edge.end == corner)) edges.push_back(edge);
    }
    return edges;
  }

  // Edges that lead as well as the best within round-off and slack; pieces that touch or overlap within the slack count
  // as just touching.
  std::vector<Edge> leading(const ConvexPiece& of, const ConvexPiece& from, double best) const {
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < of.corners.size(); ++i) {
      const Edge edge = edge_of(of, i);
      const double tie = kTie * length(along(edge));
      const double least = best > tie ? best - tie : std::min(best, 0.0) - tie - slack_;
      if (!edge.is_inner && separation(edge, from) >= least) edges.push_back(edge);
    }
    return edges;
  }

  bool corners_meet(const Leading& reference) const {
    const auto [p, q] = nearest_corners();
    const double doubt = kTie * length(along(reference.edge)) + slack_ + std::abs(reference.separation);
    return distance(at(p), at(q)) <= kNearCorner * doubt;
  }

  std::pair<VertexIndex, VertexIndex> nearest_corners() const {
    std::pair<VertexIndex, VertexIndex> nearest{a_.corners.front(), b_.corners.front()};
    double least = std::numeric_limits<double>::infinity();
    for (VertexIndex p : a_.corners) {
      for (VertexIndex q : b_.corners) {
        const double d = distance(at(p), at(q));
        if (d < least) nearest = {p, q};
        least = std::min(least, d);
      }
    }
    return nearest;
  }

  // A face that rests on springs leans by their slack over its length; that makes no corner of it.
  bool parallel(const Touch& a, const Touch& b) const {
    const Edge first{a.start, a.end}, second{b.start, b.end};
    const double shorter = std::min(length(along(first)), length(along(second)));
    return std::abs(cross(direction(first), direction(second))) < kParallel + slack_ / shorter;
  }

  Edge most_opposed(Edge reference, const ConvexPiece& other) const {
    const Point line = direction(reference);
    Edge best = edge_of(other, 0);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < other.corners.size(); ++i) {
      const Edge edge = edge_of(other, i);
      const double cosine = dot(direction(edge), line);
      if (cosine < least - kTie) {
        least = cosine;
        best = edge;
      }
    }
    return best;
  }

  bool is_wedge(const Leading& reference, Edge facing) const {
    return std::abs(cross(direction(reference.edge), direction(facing))) < kWedge &&
           dot(direction(reference.edge), direction(facing)) < 0 &&
           shared(reference, facing) > doubt(reference) + kNearCorner * std::abs(reference.separation);
  }

  bool only_ends_meet(const Leading& reference, Edge facing) const {
    return std::abs(shared(reference, facing)) <= doubt(reference);
  }

  // Length of the stretch that two edges share, negative where they share none.
  double shared(const Leading& reference, Edge facing) const {
    const double low = std::max(0.0, station(reference.edge, facing.end));
    return std::min(length(along(reference.edge)), station(reference.edge, facing.start)) - low;
  }

  // Of a stretch: round-off, slack, and what an angle that is none to the eye makes of it over the distance of the
  // edges.
  double doubt(const Leading& reference) const {
    return kTie * length(along(reference.edge)) + slack_ + kParallel * std::max(0.0, reference.separation);
  }

  // Stretch along the line of reference: that of the line itself, and the facing edge, which runs against it.
  Touches along_stretch(Edge reference, Edge facing) const {
    if (facing.is_inner) return {};
    const double own_high = length(along(reference));
    const double facing_low = station(reference, facing.end);
    const double facing_high = station(reference, facing.start);
    const double low = std::max(0.0, facing_low);
    const double high = std::min(own_high, facing_high);
    if (high < low - kTie * own_high) return {};
    Touches touches;
    touches.reserve(search_.with_middles ? 3 : 2);
    touches.push_back(facing_low >= 0 ? Touch{facing.end, reference.start, reference.end}
                                      : Touch{reference.start, facing.start, facing.end});
    touches.push_back(facing_high <= own_high ? Touch{facing.start, reference.start, reference.end}
                                              : Touch{reference.end, facing.start, facing.end});
    const double stretch = std::max(0.0, high - low);
    const bool has_middle = search_.with_middles && stretch > kTie * own_high;
    if (has_middle) {
      Touch middle{facing.start, reference.start, reference.end, TouchKind::middle};
      middle.other = facing.end;
      middle.along = (facing_high - (low + high) / 2) / (facing_high - facing_low);
      touches.insert(touches.begin() + 1, middle);
    }
    for (std::size_t i = 0; i < touches.size(); ++i) {
      const bool is_end = touches[i].kind == TouchKind::corner;
      touches[i].stretch = stretch;
      touches[i].share = !has_middle ? 0.5 : is_end ? kLobattoEnd : 1 - 2 * kLobattoEnd;
      touches[i].facing = facing_of(reference, facing, !is_end ? 1 : i == 0 ? 0 : 2);
    }
    return touches;
  }

  double station(Edge reference, VertexIndex v) const { return dot(at(v) - at(reference.start), direction(reference)); }

  const Table<VertexIndex, Point>& vertices_;
  const TouchSearch& search_;
  double slack_;
  const ConvexPiece& a_;
  const ConvexPiece& b_;
  Leading of_a_;
  Leading of_b_;
  bool a_leads_ = true;
};

// Pieces of one element share corners.
void drop_repeated(Touches& touches, std::size_t first) {
  const auto from = touches.begin() + static_cast<std::ptrdiff_t>(first);
  std::sort(from, touches.end());
  touches.erase(std::unique(from, touches.end()), touches.end());
}

}  // namespace

FoundTouches find_touches(const std::vector<ElementPair>& pairs, const Table<ElementIndex, ConvexPieces>& pieces,
                          const Table<VertexIndex, Point>& vertices, const TouchSearch& search) {
  std::vector<FoundTouches> parts(range_count(pairs.size()));
  for_ranges(pairs.size(), [&](std::size_t range, std::size_t begin, std::size_t end) {
    FoundTouches& found = parts[range];
    for (std::size_t i = begin; i < end; ++i) {
      const auto& [a, b] = pairs[i];
      const std::size_t first = found.touches.size();
      for (const ConvexPiece& of_a : pieces[a])
        for (const ConvexPiece& of_b : pieces[b])
          PairTouches(of_a, of_b, vertices, search, search.slack_of(a, b)).add_to(found, search.rounding_of(a, b));
      drop_repeated(found.touches, first);
    }
  });
  if (parts.size() == 1) return std::move(parts.front());
  FoundTouches all;
  for (FoundTouches& part : parts) {
    all.touches.insert(all.touches.end(), part.touches.begin(), part.touches.end());
    std::ranges::move(part.ties, std::back_inserter(all.ties));
  }
  return all;
}

Point outward_normal(VertexIndex start, VertexIndex end, const Table<VertexIndex, Point>& vertices) {
  const Point along = vertices[end] - vertices[start];
  return (1 / length(along)) * Point{along.y, -along.x};
}

Point normal_of(const Touch& touch, const Table<VertexIndex, Point>& vertices) {
  const Point first = outward_normal(touch.start, touch.end, vertices);
  if (touch.kind != TouchKind::bisector) return first;
  const Point sum = first + touch.second_sign * outward_normal(touch.second_start, touch.second_end, vertices);
  return (1 / length(sum)) * sum;
}

Point point_of(const Touch& touch, const Table<VertexIndex, Point>& vertices) {
  if (touch.kind != TouchKind::middle) return vertices[touch.vertex];
  return (1 - touch.along) * vertices[touch.vertex] + touch.along * vertices[touch.other];
}

double gap_of(const Touch& touch, const Table<VertexIndex, Point>& vertices) {
  const VertexIndex met = touch.kind == TouchKind::bisector ? touch.other : touch.start;
  return dot(normal_of(touch, vertices), point_of(touch, vertices) - vertices[met]);
}

bool lies_over_edge(const Touch& touch, const Table<VertexIndex, Point>& vertices) {
  if (touch.kind == TouchKind::bisector) return true;
  const Point edge = vertices[touch.end] - vertices[touch.start];
  const double station = dot(point_of(touch, vertices) - vertices[touch.start], edge) / dot(edge, edge);
  return station >= -kAtEnd && station <= 1 + kAtEnd;
}

const Touch* touch_of(const CornerTie& tie, const Table<VertexIndex, Point>& before,
                      const Table<VertexIndex, Point>& after, double overlap) {
  const auto gained = [&](const Touch& touch) { return gap_of(touch, after) - std::min(0.0, gap_of(touch, before)); };
  const Touch* best = nullptr;
  for (const Touch& touch : tie.candidates)
    if (touch.kind == TouchKind::corner && (!best || gained(touch) > gained(*best))) best = &touch;
  if (!best || gained(*best) >= -overlap) return nullptr;
  for (const Touch& touch : tie.candidates) {
    if (touch.kind != TouchKind::bisector) continue;
    Touch first = touch;
    first.kind = TouchKind::corner;
    const auto second = std::ranges::find_if(tie.candidates, [&](const Touch& t) {
      return t.kind == TouchKind::corner && t.start == touch.second_start && t.end == touch.second_end;
    });
    if (gained(first) >= gained(*best) - overlap && gained(*second) >= gained(*best) - overlap) return &touch;
  }
  return best;
}

}  // namespace keyblock
