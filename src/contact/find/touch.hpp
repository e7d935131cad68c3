// Finds the contact candidates of two elements: for each pair of convex pieces, points of one against an edge of the
// other. Theory: docs/theory/04-contact-geometry.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <compare>
#include <tuple>
#include <vector>

#include "contact/find/candidates.hpp"
#include "contact/find/convex_pieces.hpp"

namespace keyblock {

/// Kind of a contact. corner: a corner against the line of an edge. middle: a point inside an edge, against the line of
/// an edge. arc: a corner against a corner, whose relative path is two lines, along guiding edges, and an arc between
/// them.
enum class TouchKind { corner, middle, arc };

/// Name of two facing edges by their first vertices, lower one first, with the place along them. Places 0 and 2 are the
/// ends of the shared stretch, 1 is inside. The name stays the same if the reference line passes from one edge to the
/// other.
struct Facing {
  VertexIndex lower;
  VertexIndex upper;
  int place = 0;

  auto operator<=>(const Facing&) const = default;
};

/// Edge, start → end.
struct EdgeName {
  VertexIndex start;
  VertexIndex end;

  bool has(VertexIndex v) const { return start == v || end == v; }
  friend bool operator==(const EdgeName&, const EdgeName&) = default;
};

/// Contact of a point of an element with an edge of another element, whose outside lies to the right of start → end.
/// The first four members are its name, by which forces are remembered from step to step.
struct Touch {
  VertexIndex vertex;
  VertexIndex start;
  VertexIndex end;
  TouchKind kind = TouchKind::corner;
  VertexIndex other = {};  ///< middle: the point lies between `vertex` and this
  double along = 0;        ///< middle: position between `vertex` and `other`, 0 … 1
  /// arc: the edges, of the corner `start` or the corner `vertex`, that bound the relative positions. The normal of
  /// `first`, out of the element of `start`, lies clockwise of that of `second`. `end` equals `start`.
  EdgeName first = {}, second = {};
  double tangent = 0;                             ///< arc: distance of the corners at which it leaves the edges
  Facing facing = {};                             ///< empty if a corner meets a corner
  double stretch = 0;                             ///< length of the stretch that the two edges share
  double share = 1;                               ///< part of the stretch that belongs to this contact; 0 < share ≤ 1
  int joint_material = 0;                         ///< of the edge at the foot of the point
  double rest_gap = 0;                            ///< ≤ 0: overlap that existed before any force, and stays
  bool before_start = false, beyond_end = false;  ///< the edge goes on there into its element, from a reflex corner

  auto name() const { return std::tie(vertex, start, end, kind); }
  friend bool operator==(const Touch& a, const Touch& b) { return a.name() == b.name(); }
  friend auto operator<=>(const Touch& a, const Touch& b) { return a.name() <=> b.name(); }
};

using Touches = std::vector<Touch>;

/// Returns the corner guided by one of the arc's edges, as a contact along that edge.
Touch guided(const Touch& arc, EdgeName guide);

/// Returns true if `touch` is a corner along a guiding edge of `arc`; false if `arc` is not an arc.
bool is_guided(const Touch& touch, const Touch& arc);

/// Cosine of the largest angle between two faces in line, which carry a block as one: two and a half degrees.
inline constexpr double kInLine = 0.999;

/// Corner along an edge, in line with a face that ends at the corner.
struct InLine {
  Touch touch;
  VertexIndex face;  ///< start vertex
};

/// Corners of two pieces that are near each other, without contact of faces.
struct CornerMeeting {
  Touch arc;
  Touches sharp;  ///< contacts along the leading edge instead of the arc
  std::vector<InLine> in_line;
  double rounding = 0;  ///< of the corners, without the compression of springs
};

struct FoundTouches {
  Touches touches;
  std::vector<CornerMeeting> meetings;
};

/// Parameters of the contact search.
struct TouchSearch {
  double reach = 0;  ///< pieces farther apart are not in contact
  /// Overlap per element that is neglected between corners: the compression of its contact springs. Empty: 0.
  Table<ElementIndex, double> slack = {};
  bool with_middles =
      false;  ///< a third point inside each shared stretch, weights 1/6, 4/6, 1/6 (Lobatto); else two halves
  /// Overlap per element up to which corners of two elements pass each other; the smaller value counts. Null: 0.
  const Table<ElementIndex, double>* rounding = nullptr;

  double slack_of(ElementIndex a, ElementIndex b) const { return slack.empty() ? 0 : std::max(slack[a], slack[b]); }
  double rounding_of(ElementIndex a, ElementIndex b) const {
    return rounding ? std::min((*rounding)[a], (*rounding)[b]) : 0;
  }
};

/// Finds the contacts of the given pairs by geometry alone. For two convex pieces the reference line is the edge, of
/// either, from which the other has the largest separation. The points are the ends of its common stretch with the most
/// opposed edge of the other piece (Ericson 2005, separating axes and clipping, from memory). Inner edges may separate
/// pieces but have no contacts.
FoundTouches find_touches(const std::vector<ElementPair>& pairs, const Table<ElementIndex, ConvexPieces>& pieces,
                          const Table<VertexIndex, Point>& vertices, const TouchSearch& search);

/// Returns the unit normal out of the element of the edge, or of the arc at the position of the corners.
Point normal_of(const Touch& touch, const Table<VertexIndex, Point>& vertices);

/// Returns the position of the contact point.
Point point_of(const Touch& touch, const Table<VertexIndex, Point>& vertices);

/// Returns the distance of the point from the line of the edge, or from the arc; positive outside. The gap of an arc
/// depends only on the vector between both corners. On its lines one corner lies on an edge of the other (Minkowski
/// difference); a circle touches both lines.
double gap_of(const Touch& touch, const Table<VertexIndex, Point>& vertices);

/// Returns true if the foot of the point lies between the ends of the edge; always true for an arc.
bool lies_over_edge(const Touch& touch, const Table<VertexIndex, Point>& vertices);

/// Returns 0 on the first line of an arc, 1 on the second, and between them a value that follows the normal.
double share_of_second(const Touch& arc, const Table<VertexIndex, Point>& vertices);

}  // namespace keyblock
