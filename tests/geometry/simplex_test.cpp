// Simplex integrals are exact for the monomials up to second order.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/simplex.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace keyblock::simplex_test {
namespace {

void expect_near(const Moments& a, const Moments& b, double tolerance) {
  EXPECT_NEAR(a.area, b.area, tolerance);
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.xx, b.xx, tolerance);
  EXPECT_NEAR(a.yy, b.yy, tolerance);
  EXPECT_NEAR(a.xy, b.xy, tolerance);
}

/// ∫ over the rectangle (a, b) × (c, d), by hand.
Moments of_rectangle(double a, double b, double c, double d) {
  const auto power = [](double low, double high, int n) {
    double l = 1;
    double h = 1;
    for (int i = 0; i <= n; ++i) l *= low, h *= high;
    return (h - l) / (n + 1);
  };
  return {power(a, b, 0) * power(c, d, 0), power(a, b, 1) * power(c, d, 0), power(a, b, 0) * power(c, d, 1),
          power(a, b, 2) * power(c, d, 0), power(a, b, 0) * power(c, d, 2), power(a, b, 1) * power(c, d, 1)};
}

}  // namespace

TEST(Simplex, rectangle_gives_the_products_of_its_powers) {
  const std::vector<Point> loop = {{1, 2}, {4, 2}, {4, 7}, {1, 7}};
  expect_near(moments(loop, {0, 0}), of_rectangle(1, 4, 2, 7), 1e-12);
  expect_near(moments(loop, {2, 3}), of_rectangle(-1, 2, -1, 4), 1e-12);
}

TEST(Simplex, a_clockwise_hole_subtracts) {
  Moments sum = moments(std::vector<Point>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {0, 0});
  sum += moments(std::vector<Point>{{1, 1}, {1, 2}, {3, 2}, {3, 1}}, {0, 0});
  Moments expected = of_rectangle(0, 4, 0, 4);
  const Moments hole = of_rectangle(1, 3, 1, 2);
  expected += {-hole.area, -hole.x, -hole.y, -hole.xx, -hole.yy, -hole.xy};
  expect_near(sum, expected, 1e-12);
}

TEST(Simplex, a_triangle_about_its_centroid_has_no_first_moments) {
  // ∫x² = b h³ / 36 about the centroid, for the height along x (any handbook).
  const std::vector<Point> loop = {{0, 0}, {3, -1}, {3, 1}};
  const Moments m = moments(loop, {2, 0});
  EXPECT_NEAR(m.x, 0, 1e-15);
  EXPECT_NEAR(m.y, 0, 1e-15);
  EXPECT_NEAR(m.xx, 2.0 * 27 / 36, 1e-14);
  EXPECT_NEAR(m.yy, 3.0 * 8 / 48, 1e-14);
  EXPECT_NEAR(m.xy, 0, 1e-15);
}

}  // namespace keyblock::simplex_test
