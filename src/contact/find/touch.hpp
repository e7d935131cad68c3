// Where two elements may touch: of each pair of convex pieces, a few points of one against an edge of the other.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <compare>
#include <tuple>
#include <vector>

#include "contact/find/candidates.hpp"
#include "contact/find/convex_pieces.hpp"

namespace keyblock {

/// corner: a corner against the line of an edge. middle: a point inside an edge, against the line of an edge. arc: a
/// corner against a corner, along the two edges of either that guide them past each other: two lines and an arc between
/// them.
enum class TouchKind { corner, middle, arc };

/// Two edges that face each other, by their first vertices, lower one first, and where along them: 0 and 2 at the ends
/// of the stretch they share, 1 inside. It stays the same when the line of reference passes from one edge to the other.
struct Facing {
  VertexIndex lower;
  VertexIndex upper;
  int place = 0;

  auto operator<=>(const Facing&) const = default;
};

/// An edge, start → end.
struct EdgeName {
  VertexIndex start;
  VertexIndex end;

  bool has(VertexIndex v) const { return start == v || end == v; }
  friend bool operator==(const EdgeName&, const EdgeName&) = default;
};

/// A point of an element against an edge of another element, whose outside lies to the right of start → end. The first
/// four members are its name, by which forces are remembered from step to step.
struct Touch {
  VertexIndex vertex;
  VertexIndex start;
  VertexIndex end;
  TouchKind kind = TouchKind::corner;
  VertexIndex other = {};  ///< middle: the point lies between `vertex` and this
  double along = 0;        ///< middle: where between `vertex` and `other`, 0 … 1
  /// arc: the edges, of the corner `start` or of the corner `vertex`, that bound where the corners may be. The normal
  /// of `first`, out of the element of `start`, lies clockwise of that of `second`. `end` is `start`.
  EdgeName first = {}, second = {};
  double tangent = 0;      ///< arc: distance of the corners at which it leaves the edges
  Facing facing = {};      ///< neither, where a corner meets a corner
  double stretch = 0;      ///< length of the stretch that the two edges share
  double share = 1;        ///< of the stretch that this touch stands for; 0 < share ≤ 1
  int joint_material = 0;  ///< of the edge at the foot of the point
  double rest_gap = 0;     ///< ≤ 0: overlap that was there before any force, and stays

  auto name() const { return std::tie(vertex, start, end, kind); }
  friend bool operator==(const Touch& a, const Touch& b) { return a.name() == b.name(); }
  friend auto operator<=>(const Touch& a, const Touch& b) { return a.name() <=> b.name(); }
};

using Touches = std::vector<Touch>;

/// Of an arc: the corner that one of its edges guides, as a touch along that edge.
Touch guided(const Touch& arc, EdgeName guide);

/// Whether `touch` is a corner along an edge of `arc` that guides it. False where `arc` is none.
bool is_guided(const Touch& touch, const Touch& arc);

/// Cosine of the angle between two faces that are in line, and carry a block as one: two and a half degrees.
inline constexpr double kInLine = 0.999;

/// A corner along an edge with which a face that ends at the corner is in line.
struct InLine {
  Touch touch;
  VertexIndex face;  ///< where it starts
};

/// Where corners of two pieces are near each other and no face lies on a face.
struct CornerMeeting {
  Touch arc;
  Touches sharp;  ///< what touches along the leading edge instead
  std::vector<InLine> in_line;
  double rounding = 0;  ///< of the corners, whatever springs give
};

struct FoundTouches {
  Touches touches;
  std::vector<CornerMeeting> meetings;
};

/// How finely touches are searched.
struct TouchSearch {
  double reach = 0;  ///< pieces farther apart do not touch
  /// Overlap that counts as none between corner and corner, of each element: the compression of its contact springs.
  /// Empty: none.
  Table<ElementIndex, double> slack = {};
  bool with_middles =
      false;  ///< a third point inside each shared stretch, weights 1/6, 4/6, 1/6 (Lobatto); else two halves
  /// Overlap by which corners of two elements still pass each other, of each element: the lesser of the two counts.
  /// None: no overlap.
  const Table<ElementIndex, double>* rounding = nullptr;

  double slack_of(ElementIndex a, ElementIndex b) const { return slack.empty() ? 0 : std::max(slack[a], slack[b]); }
  double rounding_of(ElementIndex a, ElementIndex b) const {
    return rounding ? std::min((*rounding)[a], (*rounding)[b]) : 0;
  }
};

/// The touches of the given pairs. For two convex pieces the line of reference is the edge, of either, from which the
/// other keeps the largest separation; the points are the ends of the stretch along which the most opposed edge of the
/// other faces it. Geometry alone decides (Ericson 2005, separating axes and clipping, from memory). Inner edges
/// may keep pieces apart, but nothing touches them.
FoundTouches find_touches(const std::vector<ElementPair>& pairs, const Table<ElementIndex, ConvexPieces>& pieces,
                          const Table<VertexIndex, Point>& vertices, const TouchSearch& search);

/// Unit normal out of the element of the edge, or of the arc where the corners are.
Point normal_of(const Touch& touch, const Table<VertexIndex, Point>& vertices);

/// Where the point of the touch is.
Point point_of(const Touch& touch, const Table<VertexIndex, Point>& vertices);

/// Distance of the point from the line of the edge, or from the arc; positive outside. An arc of two corners is that of
/// a corner that nothing but their way from each other moves: the lines are where one corner lies on an edge of the
/// other one (Minkowski difference), with a circle that touches both.
double gap_of(const Touch& touch, const Table<VertexIndex, Point>& vertices);

/// Whether the foot of the point on the line of the edge lies between the ends of the edge; always on an arc.
bool lies_over_edge(const Touch& touch, const Table<VertexIndex, Point>& vertices);

/// Of an arc: 0 on the first line, 1 on the second, in between by the turn of the normal.
double share_of_second(const Touch& arc, const Table<VertexIndex, Point>& vertices);

}  // namespace keyblock
