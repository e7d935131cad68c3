// Area, centroid, orientation, containment and an inner point of closed chains of points (the first not repeated).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace keyblock {

/// Signed area, positive counter-clockwise; computed about the first vertex, so that far from the origin
/// nothing is lost.
double area(std::span<const Point> loop);

/// Centroid of the enclosed area; the mean of the vertices where the area is zero.
Point centroid(std::span<const Point> loop);

enum class Side { outside, on_edge, inside };

/// Where a point lies, by exact crossing counts (even-odd): no ray direction to be unlucky with.
Side side(std::span<const Point> loop, Point p);

/// A point that an odd number of the closed chains enclose (a polygon and its holes): on the level in the middle of the
/// highest gap between their vertices. Nothing where they enclose nothing there.
std::optional<Point> point_inside(std::span<const std::vector<Point>> loops);

/// An edge of one of several closed chains: from its corner `edge` (from 0) to the next.
struct LoopEdge {
  std::size_t loop = 0;
  std::size_t edge = 0;
};

struct EdgeCrossing {
  LoopEdge one;
  LoopEdge other;
  Point at;
};

/// The first two edges in which closed chains cross themselves or one another, or run along each other in the same
/// direction. Chains may touch. Sides are seen from `least` away, and a loop that a crossing leaves with a mean width
/// below it is passed over: that is the rounding of coordinates.
std::optional<EdgeCrossing> first_crossing(std::span<const std::vector<Point>> loops, double least);

/// The part of a convex polygon that lies to the left of the line from `start` to `end` (Sutherland & Hodgman 1974).
std::vector<Point> part_left_of(const std::vector<Point>& polygon, Point start, Point end);

}  // namespace keyblock
