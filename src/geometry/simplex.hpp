// Exact integrals of 1, x, y, x², y² and xy over a polygon, by Shi's simplex integration: the signed sum
// over the triangles (origin, vertex, next vertex).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "geometry/point.hpp"

namespace keyblock {

/// S, Sx, Sy, Sxx, Syy, Sxy about some origin.
struct Moments {
  double area = 0;
  double x = 0;
  double y = 0;
  double xx = 0;
  double yy = 0;
  double xy = 0;

  Moments& operator+=(const Moments& other);
};

/// Integrals of the coordinates relative to `origin` over the area that the loop encloses; a clockwise loop
/// (a hole) gives negative values, so a polygon with holes is the sum over its loops.
Moments moments(std::span<const Point> loop, Point origin);

}  // namespace keyblock
