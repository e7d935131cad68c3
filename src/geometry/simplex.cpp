// Sums over the triangles (origin, vertex, next vertex), each integrated exactly.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/simplex.hpp"

namespace keyblock {

Moments& Moments::operator+=(const Moments& other) {
  area += other.area;
  x += other.x;
  y += other.y;
  xx += other.xx;
  yy += other.yy;
  xy += other.xy;
  return *this;
}

// Sums integrals over triangles (0, a, b) with J = a × b (Shi 1988, simplex integration in two dimensions):
//     ∫1 = J/2, ∫x = J (ax + bx)/6, ∫x² = J (ax² + ax bx + bx²)/12, ∫xy = J (2 ax ay + ax by + bx ay + 2 bx by)/24.
Moments moments(std::span<const Point> loop, Point origin) {
  Moments sum;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point a = loop[i] - origin;
    const Point b = loop[i + 1 == loop.size() ? 0 : i + 1] - origin;
    const double j = cross(a, b);
    sum += {j / 2,
            j * (a.x + b.x) / 6,
            j * (a.y + b.y) / 6,
            j * (a.x * a.x + a.x * b.x + b.x * b.x) / 12,
            j * (a.y * a.y + a.y * b.y + b.y * b.y) / 12,
            j * (2 * a.x * a.y + a.x * b.y + b.x * a.y + 2 * b.x * b.y) / 24};
  }
  return sum;
}

}  // namespace keyblock
