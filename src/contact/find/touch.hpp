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

/// corner: a corner against the line of an edge. middle: a point inside an edge, against the line of an edge. bisector:
/// a corner against a corner, along the bisector of the normals of two edges of which neither leads.
enum class TouchKind { corner, middle, bisector };

/// Two edges that face each other, by their first vertices, lower one first, and where along them: 0 and 2 at the ends
/// of the stretch they share, 1 inside. It stays the same when the line of reference passes from one edge to the other.
struct Facing {
  VertexIndex lower;
  VertexIndex upper;
  int place = 0;

  auto operator<=>(const Facing&) const = default;
};

/// A point of an element against an edge of another element, whose outside lies to the right of start → end. The first
/// four members are its name, by which forces are remembered from step to step.
struct Touch {
  VertexIndex vertex;
  VertexIndex start;
  VertexIndex end;
  TouchKind kind = TouchKind::corner;
  VertexIndex other = {};  ///< middle: the point lies between `vertex` and this; bisector: the corner that is met
  double along = 0;        ///< middle: where between them, 0 … 1
  VertexIndex second_start = {};  ///< bisector: the second edge
  VertexIndex second_end = {};
  double second_sign = 1;  ///< bisector: −1 where the second edge is of the element of `vertex`
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

/// Corner on corner, no edge leading, or by no more than corners are rounded: which of them takes the touch cannot be
/// said before it is known how they move.
struct CornerTie {
  Touches candidates;   ///< one an edge, then one bisector a pair of edges that are not parallel
  double rounding = 0;  ///< > 0: an edge does lead, by no more than this
  Touches sharp = {};   ///< what touches along that edge
};

struct FoundTouches {
  Touches touches;
  std::vector<CornerTie> ties;
  Touches released = {};  ///< of ties: closed in the last step, and left open to see whether they still are
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

/// The touch that a tie became by a motion from `before` to `after`: the edge towards which the two approached least,
/// the bisector of two where they approached equally, none where they stayed apart by more than `overlap` (negative).
/// What overlap there was before, up to the slack, is not counted: a block that slides along a line of joints passes
/// the corners of the blocks below.
const Touch* touch_of(const CornerTie& tie, const Table<VertexIndex, Point>& before,
                      const Table<VertexIndex, Point>& after, double overlap);

/// Unit normal out of the element of the edge.
Point normal_of(const Touch& touch, const Table<VertexIndex, Point>& vertices);

/// Where the point of the touch is.
Point point_of(const Touch& touch, const Table<VertexIndex, Point>& vertices);

/// Distance of the point from the line of the edge, or from the corner along the bisector; positive outside.
double gap_of(const Touch& touch, const Table<VertexIndex, Point>& vertices);

/// Whether the foot of the point on the line of the edge lies between the ends of the edge; always for a bisector.
bool lies_over_edge(const Touch& touch, const Table<VertexIndex, Point>& vertices);

}  // namespace keyblock
