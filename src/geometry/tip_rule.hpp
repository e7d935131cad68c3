// Generates quadrature points for integrands that vary as powers of the root of the distance from a point, as fields at
// a crack tip do.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/quadrature.hpp"

namespace keyblock {

/// Returns points over the triangle (tip, from, to), with negative weights if it is clockwise. With the distance d of
/// the tip from the line of the far edge and v along that line from the foot of the perpendicular,
///       x = tip + ρ² (p(v) - tip),  v = d sinh u,
/// Gauss points of ρ and of u are used on either side of the foot. 1/√r and 1/r become polynomials of ρ, and variation
/// over d along the edge becomes even in u. (Related: almost polar rules of Laborde et al. 2005, distance
/// transformations of Ma & Kamiya 2002.) Exact along ρ for ρ^k/r to k = 10.
std::vector<AreaPoint> tip_triangle_rule(Point tip, Point from, Point to);

/// Returns points over the region to the left of closed loops (holes clockwise), for integrands from near-tip fields of
/// `tips`. Fans of such triangles are used from a tip on the region, or nearer to it than 0.35 `size`. Otherwise points
/// are exact to a degree that rises from `degree` as a tip comes near.
std::vector<AreaPoint> polygon_rule_about(std::span<const Point> tips, std::span<const std::vector<Point>> loops,
                                          double size, int degree);

/// Point of an edge and the length it represents.
struct EdgePoint {
  Point at;
  double weight = 0;
};

/// Returns points along an edge, closer near the tip that is nearest to it: by the root of the distance from its foot.
std::vector<EdgePoint> edge_rule_about(std::span<const Point> tips, const Segment& edge);

}  // namespace keyblock
