// Finds the separating edge of each pair, then the ends of the common stretch. Corners that no edge separates are
// collected apart.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/find/touch.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <span>

#include "base/loop.hpp"
#include "contact/find/piece_edges.hpp"

namespace keyblock {
namespace {

// Two separations that differ by less than this fraction of the edge are equal up to round-off. The first one found
// stays, so that parallel faces keep their reference line from step to step.
constexpr double kTie = 1e-9;
// Sine of the angle below which two edges count as parallel: half the turn of a visible corner.
constexpr double kParallel = 1e-4;
// Weight of an end point in Lobatto's three-point rule, exact for cubics (Abramowitz & Stegun 1964, 25.4.32). Springs
// at these points have the rotational stiffness of a uniformly sprung stretch, k L²/12. Two at the ends would be three
// times as stiff. The end point is the pivot.
constexpr double kLobattoEnd = 1.0 / 6;

// Corners meet if their distance is at most this times the separation of the pieces or its tolerance. This covers
// exterior angles down to thirty degrees. Faces at a small angle are equally far apart at many places, but not corner
// to corner.
constexpr double kNearCorner = 4;

// Sine of the angle below which two facing edges close like a wedge: the far end meets next, and either normal serves.
constexpr double kWedge = 0.1;

// Least and greatest length of a rounded corner, as fractions of the shorter of its two edges.
constexpr double kLeastTangent = 1e-6;
constexpr double kMostTangent = 0.4;

struct Leading {
  const Edge* edge = nullptr;
  double separation = -std::numeric_limits<double>::infinity();
};

// The two edges run in opposite directions: low on one is high on the other.
Facing facing_of(const Edge& reference, const Edge& facing, int place) {
  if (reference.start < facing.start) return {reference.start, facing.start, place};
  return {facing.start, reference.start, 2 - place};
}

// Returns a corner against an edge, which goes on beyond its reflex corners.
Touch touch_of(VertexIndex corner, const Edge& edge) {
  Touch touch{corner, edge.start, edge.end};
  touch.before_start = edge.from_reflex;
  touch.beyond_end = edge.to_reflex;
  return touch;
}

/// The two edges at a corner.
struct CornerEdges {
  const Edge& arriving;
  const Edge& leaving;
};

/// Edge that guides the corners, with its normal out of b.
struct Guide {
  const Edge* edge;
  Point normal;
};
Guide guide(const Edge& edge, double sign) {
  return {&edge, sign * Point{edge.direction.y, -edge.direction.x}};
}

// Finds the two guides that bound the common range of normals. The corner of b blocks directions between the normals of
// its edges, the corner of a those between its own, reversed. The result is empty without a common range, as at a
// diagonal of a notched block, where its next piece adjoins.
std::optional<CornerMeeting> meeting_of(const CornerEdges& a, const CornerEdges& b, double slack, double tangent) {
  const Guide first_of_a = guide(a.arriving, -1), second_of_a = guide(a.leaving, -1);
  const Guide first_of_b = guide(b.arriving, 1), second_of_b = guide(b.leaving, 1);
  const auto is_between = [](Point n, const Guide& first, const Guide& second) {
    return cross(first.normal, n) >= -kParallel && cross(n, second.normal) >= -kParallel;
  };
  const Guide& first = cross(first_of_b.normal, first_of_a.normal) > kParallel ? first_of_a : first_of_b;
  const Guide& second = cross(second_of_a.normal, second_of_b.normal) > kParallel ? second_of_a : second_of_b;
  for (const Guide& one : {first, second})
    if (one.edge->is_inner || !is_between(one.normal, first_of_a, second_of_a) ||
        !is_between(one.normal, first_of_b, second_of_b))
      return std::nullopt;
  const double shorter = std::min(first.edge->length, second.edge->length);
  if (cross(first.normal, second.normal) < kParallel + slack / shorter) return std::nullopt;
  CornerMeeting meeting;
  Touch& arc = meeting.arc;
  arc = {a.leaving.start, b.leaving.start, b.leaving.start, TouchKind::arc};
  arc.first = {first.edge->start, first.edge->end};
  arc.second = {second.edge->start, second.edge->end};
  arc.tangent = std::clamp(tangent, kLeastTangent * shorter, kMostTangent * shorter);
  const auto add_in_line = [&](const Guide& one, const Guide& of_a, const Guide& of_b) {
    if (dot(of_a.normal, of_b.normal) <= kInLine) return;
    const Guide& other = one.edge == of_a.edge ? of_b : of_a;
    meeting.in_line.push_back({guided(arc, {one.edge->start, one.edge->end}), other.edge->start});
  };
  add_in_line(first, first_of_a, first_of_b);
  add_in_line(second, second_of_a, second_of_b);
  return meeting;
}

class PairTouches {
 public:
  PairTouches(EdgesOfPiece a, EdgesOfPiece b, const Table<VertexIndex, Point>& vertices, const TouchSearch& search,
              double slack)
      : vertices_(vertices), search_(search), slack_(slack), a_(a), b_(b) {}

  void add_to(FoundTouches& found, double rounding) {
    const Leaders of_a = leaders(a_, b_), of_b = leaders(b_, a_);
    const double tie = of_b.touches.edge ? kTie * of_b.touches.edge->length : 0;
    const bool a_leads = of_a.touches.separation >= of_b.touches.separation - tie;
    const Leading& reference = a_leads ? of_a.touches : of_b.touches;
    if (!reference.edge || std::max(of_a.farthest, of_b.farthest) > search_.reach) return;
    if (is_divided(of_a.divides, reference) || is_divided(of_b.divides, reference)) return;
    nearest_ = nearest_corners(a_, b_);
    const Edge& facing = most_opposed(*reference.edge, a_leads ? b_ : a_);
    Touches sharp = along_stretch(*reference.edge, facing);
    const double tangent = std::max(slack_, rounding);
    slack_ += rounding;
    if (corners_tie(reference, facing))
      if (std::optional<CornerMeeting> meeting =
              meeting_of(edges_of(*nearest_.of_a, a_), edges_of(*nearest_.of_b, b_), slack_, tangent)) {
        meeting->sharp = std::move(sharp);
        meeting->rounding = rounding;
        found.meetings.push_back(*std::move(meeting));
        return;
      }
    found.touches.insert(found.touches.end(), sharp.begin(), sharp.end());
  }

 private:
  // Returns true if corners are near each other and no edge leads by more than the slack. Faces that close like a wedge
  // have no such corners. The test is the same before and after closing, so that a corner that approaches an edge near
  // its end meets one profile.
  bool corners_tie(const Leading& reference, const Edge& facing) const {
    if (!corners_meet(reference) || is_wedge(reference, facing)) return false;
    return crosses(leading(a_, b_, reference.separation), leading(b_, a_, reference.separation)) ||
           (only_ends_meet(reference, facing) &&
            crosses(edges_at(nearest_.of_a->start, a_), edges_at(nearest_.of_b->start, b_)));
  }

  // Returns the edges at the corner where an edge starts.
  static CornerEdges edges_of(const Edge& leaving, EdgesOfPiece of) {
    const auto place = static_cast<std::size_t>(&leaving - of.data());
    return {of[place == 0 ? of.size() - 1 : place - 1], leaving};
  }

  static double separation(const Edge& edge, EdgesOfPiece from) {
    double least = std::numeric_limits<double>::infinity();
    for (const Edge& other : from) least = std::min(least, -cross(edge.direction, other.from - edge.from));
    return least;
  }

  // Returns true if the other piece lies over the edge, at least in part, and not only over its line.
  static bool is_over(const Edge& edge, EdgesOfPiece other) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Edge& of_other : other) {
      low = std::min(low, station(edge, of_other.from));
      high = std::max(high, station(edge, of_other.from));
    }
    return low <= edge.length && high >= 0;
  }

  // Returns true if the corner nearest to the line of an edge, of those at the given separation, is not reflex.
  static bool meets_corner(const Edge& edge, EdgesOfPiece from, double separation) {
    return std::ranges::any_of(from, [&](const Edge& other) {
      return !other.from_reflex && -cross(edge.direction, other.from - edge.from) <= separation + kTie * edge.length;
    });
  }

  /// Edges of a piece with the largest separation: of those that may touch, and of inner edges, which only divide. No
  /// edge touches a reflex corner, beside which the element goes on.
  struct Leaders {
    Leading touches, divides;
    double farthest = -std::numeric_limits<double>::infinity();  ///< largest separation of all edges
  };

  // Finds the edges that lead. If two of them lie on one line, that under the other piece leads.
  static Leaders leaders(EdgesOfPiece of, EdgesOfPiece from) {
    Leaders found;
    const bool has_reflex = std::ranges::any_of(from, &Edge::from_reflex);
    for (const Edge& edge : of) {
      const double value = separation(edge, from);
      const double tie = kTie * edge.length;
      found.farthest = std::max(found.farthest, value);
      if (!edge.is_inner && has_reflex && !meets_corner(edge, from, value)) continue;
      Leading& best = edge.is_inner ? found.divides : found.touches;
      const bool leads = value > best.separation + tie;
      const bool ties = best.edge && value >= best.separation - tie;
      if (!best.edge || leads || (ties && !is_over(*best.edge, from) && is_over(edge, from))) best = {&edge, value};
    }
    return found;
  }

  // Returns true if an inner edge divides the pieces. That takes a clear margin, because it may lie on one line with an
  // edge that touches. Pieces that overlap are divided only if the reference overlaps far more: at a reflex corner both
  // depths differ by no more than the sine between diagonal and edge.
  static bool is_divided(const Leading& divides, const Leading& reference) {
    const double least = divides.separation < 0 ? divides.separation / kClearSine : divides.separation;
    return divides.edge && least > reference.separation + kTie * reference.edge->length;
  }

  // Returns true if two of the edges are not parallel.
  bool crosses(std::vector<const Edge*> edges, const std::vector<const Edge*>& of_other) const {
    edges.insert(edges.end(), of_other.begin(), of_other.end());
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (std::size_t j = i + 1; j < edges.size(); ++j)
        if (!parallel(*edges[i], *edges[j])) return true;
    return false;
  }

  static std::vector<const Edge*> edges_at(VertexIndex corner, EdgesOfPiece of) {
    std::vector<const Edge*> edges;
    for (const Edge& edge : of)
      if (!edge.is_inner && (edge.start == corner || edge.end == corner)) edges.push_back(&edge);
    return edges;
  }

  // Returns edges that lead as well as the best within round-off and slack.
  std::vector<const Edge*> leading(EdgesOfPiece of, EdgesOfPiece from, double best) const {
    std::vector<const Edge*> edges;
    for (const Edge& edge : of) {
      const double tie = kTie * edge.length;
      if (!edge.is_inner && separation(edge, from) >= best - tie - slack_) edges.push_back(&edge);
    }
    return edges;
  }

  bool corners_meet(const Leading& reference) const {
    const double doubt = kTie * reference.edge->length + slack_ + std::abs(reference.separation);
    return nearest_.distance <= kNearCorner * doubt;
  }

  /// Nearest corners that are not reflex, given by the edges that start at them.
  struct NearestCorners {
    const Edge* of_a = nullptr;
    const Edge* of_b = nullptr;
    double distance = std::numeric_limits<double>::infinity();
  };
  static NearestCorners nearest_corners(EdgesOfPiece a, EdgesOfPiece b) {
    NearestCorners nearest{&a.front(), &b.front()};
    for (const Edge& p : a)
      for (const Edge& q : b)
        if (const double d = distance(p.from, q.from); d < nearest.distance && !p.from_reflex && !q.from_reflex)
          nearest = {&p, &q, d};
    return nearest;
  }

  // A face on springs leans by their slack over its length, which does not make a corner.
  bool parallel(const Edge& first, const Edge& second) const {
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

  // Returns the length of the stretch that two edges share, negative if they share none.
  double shared(const Leading& reference, const Edge& facing) const {
    const double low = std::max(0.0, station(*reference.edge, vertices_[facing.end]));
    return std::min(reference.edge->length, station(*reference.edge, facing.from)) - low;
  }

  // Returns the uncertainty of a stretch: round-off, slack, and the effect of an invisible angle over the distance of
  // the edges.
  double doubt(const Leading& reference) const {
    return kTie * reference.edge->length + slack_ + kParallel * std::max(0.0, reference.separation);
  }

  // Finds the shared stretch along the reference line. The facing edge runs in the opposite direction. An edge does not
  // end at a reflex corner, which is no point of contact: it goes on into its element.
  Touches along_stretch(const Edge& reference, const Edge& facing) const {
    if (facing.is_inner) return {};
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    const double own_high = reference.length;
    const double facing_low = station(reference, vertices_[facing.end]);
    const double facing_high = station(reference, facing.from);
    const double tie = kTie * own_high;
    // Where both faces end together, round-off must not choose which corner names the contact.
    const bool low_of_facing = reference.from_reflex || (!facing.to_reflex && facing_low >= -tie);
    const bool high_of_facing = reference.to_reflex || (!facing.from_reflex && facing_high <= own_high + tie);
    if ((facing.to_reflex ? -kEndless : facing_low) > (reference.to_reflex ? kEndless : own_high) + tie) return {};
    if ((facing.from_reflex ? kEndless : facing_high) < (reference.from_reflex ? -kEndless : 0) - tie) return {};
    const double low = std::max(0.0, facing_low);
    const double high = std::min(own_high, facing_high);
    Touches touches;
    touches.reserve(search_.with_middles ? 3 : 2);
    touches.push_back(low_of_facing ? touch_of(facing.end, reference) : touch_of(reference.start, facing));
    touches.push_back(high_of_facing ? touch_of(facing.start, reference) : touch_of(reference.end, facing));
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
    if (reference.from_reflex || reference.to_reflex || facing.from_reflex || facing.to_reflex)
      std::erase_if(touches, [&](const Touch& touch) { return is_far_beyond(touch); });
    return touches;
  }

  // Returns true for a point beyond a reflex corner that cannot reach the line of the edge.
  bool is_far_beyond(const Touch& touch) const {
    Touch within = touch;
    within.before_start = within.beyond_end = false;
    return !lies_over_edge(within, vertices_) && gap_of(touch, vertices_) > search_.reach;
  }

  static double station(const Edge& reference, Point p) { return dot(p - reference.from, reference.direction); }

  const Table<VertexIndex, Point>& vertices_;
  const TouchSearch& search_;
  double slack_;
  EdgesOfPiece a_;
  EdgesOfPiece b_;
  NearestCorners nearest_;
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
    std::ranges::move(part.meetings, std::back_inserter(all.meetings));
  }
  return all;
}

}  // namespace keyblock
