// Orders monomials as Pascal's triangle does; see polynomial.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polynomial.hpp"

#include <cassert>

#include "geometry/quadrature.hpp"

namespace keyblock {

std::vector<Exponents> exponents(int degree) {
  std::vector<Exponents> list;
  for (int n = 0; n <= degree; ++n) {
    for (int j = 0; j <= n; ++j) list.push_back({n - j, j});
  }
  return list;
}

namespace {

template <typename Values>
void put_monomials(int degree, Point p, Values& values) {
  values(0) = 1;
  for (int n = 1; n <= degree; ++n) {
    for (int j = 0; j < n; ++j) values(monomial(n - j, j)) = p.x * values(monomial(n - 1 - j, j));
    values(monomial(0, n)) = p.y * values(monomial(0, n - 1));
  }
}

}  // namespace

OfMonomials<1> monomials(int degree, Point p) {
  assert(degree <= kHighestDegree);
  OfMonomials<1> values(monomial_count(degree));
  put_monomials(degree, p, values);
  return values;
}

OfMonomials<2> monomial_gradients(int degree, Point p) {
  assert(degree <= kHighestDegree);
  OfMonomials<2> gradients = OfMonomials<2>::Zero(monomial_count(degree), 2);
  if (degree == 0) return gradients;
  const OfMonomials<1> lower = monomials(degree - 1, p);
  for (int n = 1; n <= degree; ++n) {
    for (int j = 0; j <= n; ++j) {
      const int i = n - j;
      if (i > 0) gradients(monomial(i, j), 0) = i * lower(monomial(i - 1, j));
      if (j > 0) gradients(monomial(i, j), 1) = j * lower(monomial(i, j - 1));
    }
  }
  return gradients;
}

Eigen::VectorXd product(const Eigen::VectorXd& a, int degree_a, const Eigen::VectorXd& b, int degree_b) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(monomial_count(degree_a + degree_b));
  Eigen::Index i = 0;
  for (int n = 0; n <= degree_a; ++n) {
    for (int y = 0; y <= n; ++y, ++i) {
      Eigen::Index j = 0;
      for (int m = 0; m <= degree_b; ++m) {
        for (int z = 0; z <= m; ++z, ++j) result(monomial(n - y + m - z, y + z)) += a(i) * b(j);
      }
    }
  }
  return result;
}

// For a homogeneous f of degree n, ∫ f over the triangle (0, a, b) = a × b / (n + 2) ∫₀¹ f(a + t (b - a)) dt (Euler's
// relation and Green's theorem). The line integral is that of a polynomial of degree n, by Gauss.
Eigen::VectorXd polygon_moments(std::span<const std::vector<Point>> loops, const LocalFrame& frame, int degree) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(monomial_count(degree));
  const GaussRule& rule = gauss_rule(degree / 2 + 1);
  Eigen::VectorXd at_point(monomial_count(degree));
  for (const std::vector<Point>& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point a = frame.local(loop[i]);
      const Point b = frame.local(loop[i + 1 == loop.size() ? 0 : i + 1]);
      const double twice_area = cross(a, b);
      for (const GaussPoint& g : rule) {
        put_monomials(degree, a + g.at * (b - a), at_point);
        sum += twice_area * g.weight * at_point;
      }
    }
  }
  for (int n = 0; n <= degree; ++n) sum.segment(monomial(n, 0), n + 1) *= frame.size * frame.size / (n + 2);
  return sum;
}

}  // namespace keyblock
