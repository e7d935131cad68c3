// Integrals about a tip against closed forms: 1/r, in all directions and in some, and roots of the distance.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/tip_rule.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace keyblock::tip_rule_test {
namespace {

/// ∫ 1/r over the triangle (tip, a, b): d (asinh(v_b/d) - asinh(v_a/d)), for ∫ dr = d / cos φ and tan φ = v/d.
double inverse_distance(Point tip, Point a, Point b) {
  const double size = distance(a, b);
  const double d = cross(a - tip, b - tip) / size;
  if (std::abs(d) < 1e-15) return 0;
  const Point along = (1 / size) * (b - a);
  return d * (std::asinh(dot(b - tip, along) / std::abs(d)) - std::asinh(dot(a - tip, along) / std::abs(d)));
}

/// ∫ cos² φ / r over the same, φ from the perpendicular to the edge: d (sin φ_b - sin φ_a).
double inverse_distance_across(Point tip, Point a, Point b) {
  const double size = distance(a, b);
  const double d = cross(a - tip, b - tip) / size;
  const Point along = (1 / size) * (b - a);
  return d * (dot(b - tip, along) / distance(tip, b) - dot(a - tip, along) / distance(tip, a));
}

template <class F>
double sum(const std::vector<AreaPoint>& points, F f) {
  double total = 0;
  for (const AreaPoint& p : points) total += p.weight * f(p.at);
  return total;
}

const std::vector<Point> kTriangle{{0, 0}, {1, 0}, {0.5, 0.8}};

double over_polygon(const std::vector<Point>& loop, Point tip) {
  double total = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) total += inverse_distance(tip, loop[i], loop[(i + 1) % loop.size()]);
  return total;
}

}  // namespace

TEST(TipRule, triangles_of_any_height_integrate_the_inverse_distance) {
  const Point tip{0.3, 0.1};
  for (const double height : {1.0, 0.3, 0.1, 1e-2, 1e-4}) {
    for (const auto& [from, to] : {std::pair{-0.7, 0.4}, {0.1, 0.9}, {0.0, 0.5}, {-0.9, -0.2}}) {
      const Point a = tip + Point{from, -height}, b = tip + Point{to, -height};
      const double exact = inverse_distance(tip, a, b), across = inverse_distance_across(tip, a, b);
      const auto points = tip_triangle_rule(tip, a, b);
      EXPECT_NEAR(sum(points, [&](Point x) { return 1 / distance(x, tip); }), exact, 1e-11 * exact) << height;
      if (height >= 1e-2) {  // nearer tips are known on average over all directions
        EXPECT_NEAR(sum(points,
                        [&](Point x) {
                          const double c = (tip.y - x.y) / distance(x, tip);
                          return c * c / distance(x, tip);
                        }),
                    across, 1e-5 * exact)
            << height << " " << from;
      }
      const auto back = tip_triangle_rule(tip, b, a);
      EXPECT_NEAR(sum(back, [&](Point x) { return 1 / distance(x, tip); }), -exact, 1e-11 * exact) << "clockwise";
    }
  }
  EXPECT_TRUE(tip_triangle_rule(tip, tip, {1, 1}).empty()) << "an edge through the tip";
}

// A tip on a corner, on a side, inside, just outside and farther and farther off: one closed form.
TEST(TipRule, polygons_integrate_the_inverse_distance_wherever_the_tip_is) {
  const std::vector<std::vector<Point>> loops{kTriangle};
  const std::array<Point, 12> places{Point{0, 0}, {0.5, 0},     {0.5, 0.3},   {0.5, 1e-6}, {0.5, -1e-6}, {0.5, -0.1},
                                     {0.5, -0.2}, {0.5, -0.34}, {0.5, -0.36}, {0.5, -0.6}, {-1.1, 0.2},  {3, 1}};
  for (const Point tip : places) {
    const std::array<Point, 1> tips{tip};
    const double exact = over_polygon(kTriangle, tip);
    const double found = sum(polygon_rule_about(tips, loops, 1, 4), [&](Point x) { return 1 / distance(x, tip); });
    EXPECT_NEAR(found, exact, 1e-6 * exact) << tip.x << " " << tip.y;
  }
}

TEST(TipRule, areas_are_those_of_the_polygon_with_a_hole_and_a_slit) {
  // The last loop of corners walks into the slit and out of it again.
  const std::vector<std::vector<Point>> loops{{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}, {1, 1}, {0, 1}},
                                              {{1.2, 0.4}, {1.2, 0.6}, {1.6, 0.6}, {1.6, 0.4}}};
  const std::array<Point, 1> tips{Point{1, 1}};
  EXPECT_NEAR(sum(polygon_rule_about(tips, loops, 2, 4), [](Point) { return 1.0; }), 4 - 0.08, 1e-13);
  EXPECT_NEAR(sum(polygon_rule_about(tips, loops, 2, 4), [](Point x) { return x.x * x.y; }), 4 - 0.08 * 1.4 * 0.5,
              1e-13);
}

TEST(TipRule, edges_integrate_roots_of_the_distance) {
  const auto along = [](const std::vector<EdgePoint>& points, auto f) {
    double total = 0;
    for (const EdgePoint& p : points) total += p.weight * f(p.at);
    return total;
  };
  const Segment edge{{0, 0}, {0.6, 0.8}};
  for (const double t : {0.0, 0.3, 1.0}) {
    const Point tip = {0.6 * t, 0.8 * t};
    const std::array<Point, 1> tips{tip};
    const auto points = edge_rule_about(tips, edge);
    EXPECT_NEAR(along(points, [](Point) { return 1.0; }), 1, 1e-14);
    EXPECT_NEAR(along(points, [&](Point x) { return 1 / std::sqrt(distance(x, tip)); }),
                2 * (std::sqrt(t) + std::sqrt(1 - t)), 1e-12);
    EXPECT_NEAR(along(points, [&](Point x) { return std::sqrt(distance(x, tip)); }),
                2.0 / 3 * (std::pow(t, 1.5) + std::pow(1 - t, 1.5)), 1e-12);
  }
}

}  // namespace keyblock::tip_rule_test
