// Computes exact integrals of 1, x, y, x², y², xy over polygons (Shi's simplex integration; Green's theorem on straight
// edges).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "geometry/point.hpp"

namespace keyblock {

/// Area moments: ∫1, ∫x, ∫y, ∫x², ∫y², ∫xy.
struct Moments {
  double area = 0;
  double x = 0;
  double y = 0;
  double xx = 0;
  double yy = 0;
  double xy = 0;

  Moments& operator+=(const Moments& other);
};

/// Returns moments about `origin` of the region to the left of the closed `loop`; clockwise loops (holes) count
/// negative. An origin near the loop makes the result exact to round-off of the loop's own size.
Moments moments(std::span<const Point> loop, Point origin);

}  // namespace keyblock
