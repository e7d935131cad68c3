// Finds Gauss–Legendre points by Newton's method, and their products over triangles; see quadrature.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

constexpr int kMostPoints = 16;

// Roots x of the Legendre polynomial P_n with weights 2 / ((1 - x²) P_n'(x)²), mapped from -1..1 to 0..1.
GaussRule legendre_rule(int n) {
  GaussRule rule;
  for (int k = n; k >= 1; --k) {
    double x = std::cos(std::numbers::pi * (k - 0.25) / (n + 0.5));
    double slope = 1;
    for (int pass = 0; pass < 8; ++pass) {
      double before = 0;
      double value = 1;
      for (int j = 1; j <= n; ++j) {
        const double next = ((2 * j - 1) * x * value - (j - 1) * before) / j;
        before = value;
        value = next;
      }
      slope = n * (before - x * value) / (1 - x * x);
      x -= value / slope;
    }
    rule.push_back({(1 + x) / 2, 1 / ((1 - x * x) * slope * slope)});
  }
  return rule;
}

void add_triangle(const std::array<Point, 3>& t, int degree, std::vector<AreaPoint>& points) {
  const double twice_area = cross(t[1] - t[0], t[2] - t[0]);
  const GaussRule& along = gauss_rule((degree + 3) / 2);  // one degree more: the width of the strip
  const GaussRule& across = gauss_rule(degree / 2 + 1);
  for (const GaussPoint& a : along) {
    for (const GaussPoint& b : across) {
      const Point at = t[0] + a.at * ((1 - b.at) * (t[1] - t[0]) + b.at * (t[2] - t[0]));
      points.push_back({at, twice_area * a.weight * b.weight * a.at});
    }
  }
}

}  // namespace

const GaussRule& gauss_rule(int count) {
  static const std::array<GaussRule, kMostPoints + 1> rules = [] {
    std::array<GaussRule, kMostPoints + 1> made;
    for (int n = 1; n <= kMostPoints; ++n) made[static_cast<std::size_t>(n)] = legendre_rule(n);
    return made;
  }();
  assert(count >= 1 && count <= kMostPoints && "a Gauss rule has 1 to 16 points");
  return rules[static_cast<std::size_t>(count)];
}

std::vector<AreaPoint> triangle_rule(const std::array<Point, 3>& triangle, int degree) {
  std::vector<AreaPoint> points;
  add_triangle(triangle, degree, points);
  return points;
}

std::vector<AreaPoint> polygon_rule(std::span<const std::vector<Point>> loops, int degree) {
  std::vector<AreaPoint> points;
  const Point apex = loops.front().front();
  for (const std::vector<Point>& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point next = loop[i + 1 == loop.size() ? 0 : i + 1];
      if (cross(loop[i] - apex, next - apex) != 0) add_triangle({apex, loop[i], next}, degree, points);
    }
  }
  return points;
}

}  // namespace keyblock
