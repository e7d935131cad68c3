// Moments of polygons and rules of quadrature compared with integrals by hand.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polynomial.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "geometry/quadrature.hpp"

namespace keyblock::polynomial_test {
namespace {

// ∫ xⁱ yʲ over the triangle (0,0), (1,0), (0,1) = i! j! / (i + j + 2)!.
double of_unit_triangle(int i, int j) {
  return std::tgamma(i + 1.0) * std::tgamma(j + 1.0) / std::tgamma(i + j + 3.0);
}

const std::vector<std::vector<Point>> kUnitTriangle = {{{0, 0}, {1, 0}, {0, 1}}};

}  // namespace

TEST(Polynomial, moments_of_the_unit_triangle_are_products_of_factorials) {
  const Eigen::VectorXd moments = polygon_moments(kUnitTriangle, {}, 6);
  for (const Exponents& e : exponents(6)) EXPECT_NEAR(moments(monomial(e.x, e.y)), of_unit_triangle(e.x, e.y), 1e-15);
}

// A square of side 2 about the origin less a clockwise square of side 1: ∫ x⁴ = 2·(2/5) - 1·(2·0.5⁵/5), in a frame that
// is shifted and scaled.
TEST(Polynomial, holes_count_negative_and_the_frame_is_taken_out) {
  const auto square = [](double a) { return std::vector<Point>{{-a, -a}, {a, -a}, {a, a}, {-a, a}}; };
  std::vector<std::vector<Point>> loops = {square(1), square(0.5)};
  std::swap(loops[1][1], loops[1][3]);
  for (auto& loop : loops)
    for (Point& p : loop) p = Point{1000, -7} + 4 * p;
  const Eigen::VectorXd moments = polygon_moments(loops, {{1000, -7}, 4}, 4);
  EXPECT_NEAR(moments(0), 16 * 3, 1e-12);
  EXPECT_NEAR(moments(monomial(4, 0)), 16 * (0.8 - 2 * std::pow(0.5, 5) / 5), 1e-12);
  EXPECT_NEAR(moments(monomial(1, 1)), 0, 1e-12);
}

TEST(Polynomial, the_product_has_the_values_of_its_factors) {
  const Eigen::Vector3d a(1, -2, 3);
  const Eigen::VectorXd b = (Eigen::VectorXd(6) << 0.5, 1, -1, 2, 4, -3).finished();
  const Point p{0.3, -0.7};
  EXPECT_NEAR(product(a, 1, b, 2).dot(monomials(3, p)), a.dot(monomials(1, p)) * b.dot(monomials(2, p)), 1e-14);
}

TEST(Polynomial, gradients_are_those_of_the_monomials) {
  const Point p{0.3, -0.7};
  const Eigen::MatrixX2d gradients = monomial_gradients(3, p);
  EXPECT_NEAR(gradients(monomial(2, 1), 0), 2 * 0.3 * -0.7, 1e-15);
  EXPECT_NEAR(gradients(monomial(2, 1), 1), 0.09, 1e-15);
  EXPECT_NEAR(gradients(monomial(0, 3), 1), 3 * 0.49, 1e-15);
  EXPECT_EQ(gradients(0, 0), 0);
}

TEST(Quadrature, a_rule_is_exact_to_its_degree) {
  for (int degree = 0; degree <= 10; ++degree) {
    for (const Exponents& e : exponents(degree)) {
      double sum = 0;
      for (const AreaPoint& p : triangle_rule({Point{0, 0}, {1, 0}, {0, 1}}, degree))
        sum += p.weight * std::pow(p.at.x, e.x) * std::pow(p.at.y, e.y);
      EXPECT_NEAR(sum, of_unit_triangle(e.x, e.y), 1e-15) << degree;
    }
  }
}

// An L of three unit squares: ∫ x = (0.5 + 1.5) + 0.5 = 2.5, a fan from its corner (0, 2) walks outside.
TEST(Quadrature, a_fan_over_a_notch_takes_back_what_lies_outside) {
  const std::vector<std::vector<Point>> loops = {{{0, 2}, {0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}}};
  double area = 0;
  double x = 0;
  for (const AreaPoint& p : polygon_rule(loops, 1)) {
    area += p.weight;
    x += p.weight * p.at.x;
  }
  EXPECT_NEAR(area, 3, 1e-14);
  EXPECT_NEAR(x, 2.5, 1e-14);
}

}  // namespace keyblock::polynomial_test
