// Separating edge of each pair, then the ends of the common stretch; corners where no edge leads are put aside.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/find/touch.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <span>

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
  Point from;       ///< where it starts
  Point direction;  ///< of length 1
  double length = 0;

  Edge(VertexIndex first, VertexIndex last, bool inner, const Table<VertexIndex, Point>& vertices)
      : start(first), end(last), is_inner(inner), from(vertices[first]) {
    const Point along = vertices[last] - from;
    length = keyblock::length(along);
    direction = (1 / length) * along;
  }
};

/// The edges of a convex piece, which start at its corners.
using EdgesOfPiece = std::span<const Edge>;

/// The edges of all elements of some pairs: a block is in half a dozen of them.
class EdgesOfPieces {
 public:
  EdgesOfPieces(const std::vector<ElementPair>& pairs, const Table<ElementIndex, ConvexPieces>& pieces,
                const Table<VertexIndex, Point>& vertices)
      : pieces_(pieces), first_(pieces.size(), kNone) {
    const auto add = [&](ElementIndex e) {
      if (first_[e] != kNone) return;
      first_[e] = edges_.size();
      for (const ConvexPiece& piece : pieces[e])
        for (std::size_t i = 0; i < piece.corners.size(); ++i)
          edges_.emplace_back(piece.corners[i], piece.corners[i + 1 == piece.corners.size() ? 0 : i + 1],
                              piece.is_inner[i], vertices);
    };
    for (const ElementPair& pair : pairs) {
      add(pair.lower);
      add(pair.upper);
    }
  }

  template <class Visit>
  void for_each_piece(ElementIndex e, const Visit& visit) const {
    std::size_t first = first_[e];
    for (const ConvexPiece& piece : pieces_[e]) {
      visit(EdgesOfPiece(edges_).subspan(first, piece.corners.size()));
      first += piece.corners.size();
    }
  }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  const Table<ElementIndex, ConvexPieces>& pieces_;
  Table<ElementIndex, std::size_t> first_;  ///< in `edges_`
  std::vector<Edge> edges_;
};

struct Leading {
  const Edge* edge = nullptr;
  double separation = -std::numeric_limits<double>::infinity();
};

Touch against(const Edge& e, VertexIndex vertex, VertexIndex met) {
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
Facing facing_of(const Edge& reference, const Edge& facing, int place) {
  if (reference.start < facing.start) return {reference.start, facing.start, place};
  return {facing.start, reference.start, 2 - place};
}

class PairTouches {
 public:
  PairTouches(EdgesOfPiece a, EdgesOfPiece b, const Table<VertexIndex, Point>& vertices, const TouchSearch& search,
              double slack)
      : vertices_(vertices),
        search_(search),
        slack_(slack),
        a_(a),
        b_(b),
        of_a_(best_edge(a, b)),
        of_b_(best_edge(b, a)) {
    a_leads_ = of_a_.separation >= of_b_.separation - kTie * of_b_.edge->length;
  }

  void add_to(FoundTouches& found, double rounding) {
    const Leading& reference = a_leads_ ? of_a_ : of_b_;
    if (reference.separation > search_.reach || reference.edge->is_inner) return;
    nearest_ = nearest_corners(a_, b_);
    const Edge& facing = most_opposed(*reference.edge, a_leads_ ? b_ : a_);
    CornerTie tie = tie_between(reference, facing);
    if (!tie.candidates.empty()) {
      found.ties.push_back(std::move(tie));
      return;
    }
    Touches touches = along_stretch(*reference.edge, facing);
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
  CornerTie tie_between(const Leading& reference, const Edge& facing) const {
    if (!corners_meet(reference) || is_wedge(reference, facing)) return {};
    CornerTie tie = tie_of(leading(a_, b_, reference.separation), leading(b_, a_, reference.separation));
    if (tie.candidates.empty() && only_ends_meet(reference, facing)) tie = tie_at_corners();
    return tie;
  }

  static double separation(const Edge& edge, EdgesOfPiece from) {
    double least = std::numeric_limits<double>::infinity();
    for (const Edge& other : from) least = std::min(least, -cross(edge.direction, other.from - edge.from));
    return least;
  }

  // Whether the other piece lies over the edge, at least in part, and not over its line alone.
  static bool is_over(const Edge& edge, EdgesOfPiece other) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Edge& of_other : other) {
      low = std::min(low, station(edge, of_other.from));
      high = std::max(high, station(edge, of_other.from));
    }
    return low <= edge.length && high >= 0;
  }

  // An inner edge leads only if it leads clearly: it may lie on one line with an edge of the boundary. Of two edges of
  // the boundary on one line that leads over which the other piece lies.
  static Leading best_edge(EdgesOfPiece of, EdgesOfPiece from) {
    Leading best;
    for (const Edge& edge : of) {
      const double value = separation(edge, from);
      const double tie = kTie * edge.length;
      const bool leads = value > best.separation + tie;
      const bool ties = best.edge && !edge.is_inner && value >= best.separation - tie;
      const bool replaces = ties && (best.edge->is_inner || (!is_over(*best.edge, from) && is_over(edge, from)));
      if (!best.edge || leads || replaces) best = {&edge, value};
    }
    return best;
  }

  // Edges of either piece that lead as well as the best, if two of them are not parallel.
  CornerTie tie_of(const std::vector<const Edge*>& of_a, const std::vector<const Edge*>& of_b) const {
    if (of_a.size() + of_b.size() < 2) return {};
    const VertexIndex p = nearest_.of_a->start;
    const VertexIndex q = nearest_.of_b->start;
    CornerTie tie;
    for (const Edge* e : of_a) tie.candidates.push_back(against(*e, q, p));
    for (const Edge* e : of_b) tie.candidates.push_back(against(*e, p, q));
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
    return tie_of(edges_at(nearest_.of_a->start, a_), edges_at(nearest_.of_b->start, b_));
  }

  static std::vector<const Edge*> edges_at(VertexIndex corner, EdgesOfPiece of) {
    std::vector<const Edge*> edges;
    for (const Edge& edge : of)
      if (!edge.is_inner && (edge.start == corner || edge.end == corner)) edges.push_back(&edge);
    return edges;
  }

  // Edges that lead as well as the best within round-off and slack; pieces that touch or overlap within the slack count
  // as just touching.
  std::vector<const Edge*> leading(EdgesOfPiece of, EdgesOfPiece from, double best) const {
    std::vector<const Edge*> edges;
    for (const Edge& edge : of) {
      const double tie = kTie * edge.length;
      const double least = best > tie ? best - tie : std::min(best, 0.0) - tie - slack_;
      if (!edge.is_inner && separation(edge, from) >= least) edges.push_back(&edge);
    }
    return edges;
  }

  bool corners_meet(const Leading& reference) const {
    const double doubt = kTie * reference.edge->length + slack_ + std::abs(reference.separation);
    return nearest_.distance <= kNearCorner * doubt;
  }

  /// Corners by the edges that start at them.
  struct NearestCorners {
    const Edge* of_a = nullptr;
    const Edge* of_b = nullptr;
    double distance = std::numeric_limits<double>::infinity();
  };
  static NearestCorners nearest_corners(EdgesOfPiece a, EdgesOfPiece b) {
    NearestCorners nearest{&a.front(), &b.front()};
    for (const Edge& p : a)
      for (const Edge& q : b)
        if (const double d = distance(p.from, q.from); d < nearest.distance) nearest = {&p, &q, d};
    return nearest;
  }

  // A face that rests on springs leans by their slack over its length; that makes no corner of it.
  bool parallel(const Touch& a, const Touch& b) const {
    const Edge first(a.start, a.end, false, vertices_);
    const Edge second(b.start, b.end, false, vertices_);
    const double shorter = std::min(first.length, second.length);
    return std::abs(cross(first.direction, second.direction)) < kParallel + slack_ / shorter;
  }

  static const Edge& most_opposed(const Edge& reference, EdgesOfPiece other) {
    const Edge* best = &other.front();
    double least = std::numeric_limits<double>::infinity();
    for (const Edge& edge : other) {
      const double cosine = dot(edge.direction, reference.direction);
      if (cosine < least - kTie) {
        least = cosine;
        best = &edge;
      }
    }
    return *best;
  }

  bool is_wedge(const Leading& reference, const Edge& facing) const {
    return std::abs(cross(reference.edge->direction, facing.direction)) < kWedge &&
           dot(reference.edge->direction, facing.direction) < 0 &&
           shared(reference, facing) > doubt(reference) + kNearCorner * std::abs(reference.separation);
  }

  bool only_ends_meet(const Leading& reference, const Edge& facing) const {
    return std::abs(shared(reference, facing)) <= doubt(reference);
  }

  // Length of the stretch that two edges share, negative where they share none.
  double shared(const Leading& reference, const Edge& facing) const {
    const double low = std::max(0.0, station(*reference.edge, vertices_[facing.end]));
    return std::min(reference.edge->length, station(*reference.edge, facing.from)) - low;
  }

  // Of a stretch: round-off, slack, and what an angle that is none to the eye makes of it over the distance of the
  // edges.
  double doubt(const Leading& reference) const {
    return kTie * reference.edge->length + slack_ + kParallel * std::max(0.0, reference.separation);
  }

  // Stretch along the line of reference: that of the line itself, and the facing edge, which runs against it.
  Touches along_stretch(const Edge& reference, const Edge& facing) const {
    if (facing.is_inner) return {};
    const double own_high = reference.length;
    const double facing_low = station(reference, vertices_[facing.end]);
    const double facing_high = station(reference, facing.from);
    const double low = std::max(0.0, facing_low);
    const double high = std::min(own_high, facing_high);
    if (high < low - kTie * own_high) return {};
    Touches touches;
    touches.reserve(search_.with_middles ? 3 : 2);
    // Where both faces end together, round-off does not choose whose corner names the touch.
    const double tie = kTie * own_high;
    touches.push_back(facing_low >= -tie ? Touch{facing.end, reference.start, reference.end}
                                         : Touch{reference.start, facing.start, facing.end});
    touches.push_back(facing_high <= own_high + tie ? Touch{facing.start, reference.start, reference.end}
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

  static double station(const Edge& reference, Point p) { return dot(p - reference.from, reference.direction); }

  const Table<VertexIndex, Point>& vertices_;
  const TouchSearch& search_;
  double slack_;
  EdgesOfPiece a_;
  EdgesOfPiece b_;
  Leading of_a_;
  Leading of_b_;
  NearestCorners nearest_;
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
  const EdgesOfPieces edges(pairs, pieces, vertices);
  std::vector<FoundTouches> parts(range_count(pairs.size()));
  for_ranges(pairs.size(), [&](std::size_t range, std::size_t begin, std::size_t end) {
    FoundTouches& found = parts[range];
    for (std::size_t i = begin; i < end; ++i) {
      const auto& [a, b] = pairs[i];
      const std::size_t first = found.touches.size();
      edges.for_each_piece(a, [&, a = a, b = b](EdgesOfPiece of_a) {
        edges.for_each_piece(b, [&](EdgesOfPiece of_b) {
          PairTouches(of_a, of_b, vertices, search, search.slack_of(a, b)).add_to(found, search.rounding_of(a, b));
        });
      });
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
