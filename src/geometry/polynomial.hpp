// Handles polynomials of the plane, stored as coefficients of 1, x, y, x², xy, y², x³, …, and their exact integrals
// over polygons.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace keyblock {

constexpr int monomial_count(int degree) {
  return (degree + 1) * (degree + 2) / 2;
}
/// Returns the place of xⁱ yʲ.
constexpr int monomial(int i, int j) {
  return (i + j) * (i + j + 1) / 2 + j;
}

struct Exponents {
  int x = 0;
  int y = 0;
};
/// Returns the place of a monomial.
constexpr int monomial_place(Exponents e) {
  return monomial(e.x, e.y);
}
/// Returns the exponents of all monomials up to `degree`, in their order.
std::vector<Exponents> exponents(int degree);

/// Coordinates near 1 about a near origin: no digits are lost far from (0, 0), and powers stay comparable.
struct LocalFrame {
  Point origin;
  double size = 1;

  Point local(Point p) const { return (1 / size) * (p - origin); }
};

/// Highest degree of `monomials`, twice that of any cover function. Monomials are evaluated at very many points, so
/// they have a fixed greatest size and need no allocation.
inline constexpr int kHighestDegree = 6;
template <int kColumns>
using OfMonomials = Eigen::Matrix<double, Eigen::Dynamic, kColumns, 0, monomial_count(kHighestDegree), kColumns>;

/// Returns all monomials up to `degree`, at most kHighestDegree, at `p`.
OfMonomials<1> monomials(int degree, Point p);

/// Returns their derivatives by x and y, one column each.
OfMonomials<2> monomial_gradients(int degree, Point p);

/// Returns the product of polynomials of degree `degree_a` and `degree_b`.
Eigen::VectorXd product(const Eigen::VectorXd& a, int degree_a, const Eigen::VectorXd& b, int degree_b);

/// Returns ∫ of all monomials of the local coordinates up to `degree` over the region to the left of the closed loops.
/// Clockwise loops (holes) count negative; area is in the squared unit of the loops.
Eigen::VectorXd polygon_moments(std::span<const std::vector<Point>> loops, const LocalFrame& frame, int degree);

}  // namespace keyblock
