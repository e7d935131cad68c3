// Computes area, centroid, orientation, containment and an inner point of closed chains (first point not repeated).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace keyblock {

/// Returns the signed area, positive counter-clockwise. It is computed about the first vertex, so that no digits are
/// lost far from the origin.
double area(std::span<const Point> loop);

/// Returns the centroid of the enclosed area, or the mean of the vertices if the area is zero.
Point centroid(std::span<const Point> loop);

enum class Side { outside, on_edge, inside };

/// Returns the side of a point by the parity of exact crossing counts, which have no unlucky ray direction.
Side side(std::span<const Point> loop, Point p);

/// Returns a point inside a polygon with holes, by the parity of the closed chains around it. It lies at the middle
/// height of the highest gap between their vertices. Returns nothing if they enclose no point there.
std::optional<Point> point_inside(std::span<const std::vector<Point>> loops);

/// Edge of one of several closed chains: from its corner `edge` (from 0) to the next.
struct LoopEdge {
  std::size_t loop = 0;
  std::size_t edge = 0;
};

struct EdgeCrossing {
  LoopEdge one;
  LoopEdge other;
  Point at;
};

/// Returns the first two edges in which closed chains cross themselves or one another, or run along each other in the
/// same direction. Chains may touch. Sides are decided at the distance `least`. A loop cut off by a crossing is ignored
/// if its mean width is below `least`, the rounding of coordinates.
std::optional<EdgeCrossing> first_crossing(std::span<const std::vector<Point>> loops, double least);

/// Returns the part of a convex polygon to the left of the line from `start` to `end` (Sutherland & Hodgman 1974).
std::vector<Point> part_left_of(const std::vector<Point>& polygon, Point start, Point end);

}  // namespace keyblock
