// Generates points and weights that integrate polynomials exactly over edges, triangles and polygons.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace keyblock {

struct GaussPoint {
  double at = 0;  ///< in 0..1
  double weight = 0;
};
using GaussRule = std::vector<GaussPoint>;

/// Returns the Gauss–Legendre rule on 0..1 with 1 to 16 points: exact to degree 2 count - 1.
const GaussRule& gauss_rule(int count);

/// Point of the plane and its share of the area; negative in triangles of a fan with negative sign.
struct AreaPoint {
  Point at;
  double weight = 0;
};

/// Returns points exact to `degree` over a counter-clockwise triangle (Gauss points of a square collapsed into it).
std::vector<AreaPoint> triangle_rule(const std::array<Point, 3>& triangle, int degree);

/// Returns points exact to `degree` over the region to the left of closed loops (holes clockwise): a fan of signed
/// triangles from the first corner. Points may lie outside the polygon, but not outside its convex hull.
std::vector<AreaPoint> polygon_rule(std::span<const std::vector<Point>> loops, int degree);

}  // namespace keyblock
