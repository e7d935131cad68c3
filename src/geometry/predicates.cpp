// Computes exact signs of small polynomials in the coordinates; see predicates.hpp. Error bounds follow Shewchuk,
// "Adaptive precision floating-point arithmetic and fast robust geometric predicates" (1997). Bound A of orient2d holds
// for every 2 × 2 determinant of coordinate differences.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/predicates.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace keyblock {
namespace {

using Integer = boost::multiprecision::cpp_int;

constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2;  // 2^-53, unit round-off
constexpr double kDeterminantBound = (3 + 16 * kUnit) * kUnit;        // relative to the sum of the products

constexpr int kMantissaBits = 53;

/// Returns the exponent of the lowest bit that a double can carry; 0 sets no limit.
int low_exponent(double value) {
  return value == 0 ? std::numeric_limits<int>::max() : std::ilogb(value) - (kMantissaBits - 1);
}

struct ExactPoint {
  Integer x;
  Integer y;
};

ExactPoint operator-(const ExactPoint& a, const ExactPoint& b) {
  return {a.x - b.x, a.y - b.y};
}
Integer cross(const ExactPoint& a, const ExactPoint& b) {
  return a.x * b.y - a.y * b.x;
}
Integer dot(const ExactPoint& a, const ExactPoint& b) {
  return a.x * b.x + a.y * b.y;
}

Integer scaled(double value, int exponent) {
  if (value == 0) return 0;
  const int low = low_exponent(value);
  const auto mantissa = static_cast<std::int64_t>(std::scalbn(value, -low));
  return Integer(mantissa) << (low - exponent);
}

/// Returns the points as integers in one common power of two.
template <std::size_t N>
std::array<ExactPoint, N> exact(const std::array<Point, N>& points) {
  int exponent = std::numeric_limits<int>::max();
  for (const Point& p : points) exponent = std::min({exponent, low_exponent(p.x), low_exponent(p.y)});
  std::array<ExactPoint, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = {scaled(points[i].x, exponent), scaled(points[i].y, exponent)};
  return result;
}

int sign(double value) {
  return (value > 0) - (value < 0);
}

/// Difference of two products with the bound of its error.
struct Estimate {
  double value;
  double error;
};

Estimate difference_of_products(double a, double b, double c, double d) {
  const double left = a * b;
  const double right = c * d;
  return {left - right, kDeterminantBound * (std::fabs(left) + std::fabs(right))};
}

bool is_certain(const Estimate& e) {
  return std::fabs(e.value) > e.error;
}

/// Numerator and denominator of a station; the denominator is not negative.
struct Quotient {
  Integer numerator;
  Integer denominator;
};

Quotient station_quotient(const Segment& base, const Segment& mark) {
  const auto p = exact(std::array{base.start, base.end, mark.start, mark.end});
  const ExactPoint along = p[1] - p[0];
  const ExactPoint offset = p[2] - p[0];
  if (mark.start == mark.end) return {dot(offset, along), dot(along, along)};
  const ExactPoint back = p[2] - p[3];
  const Integer denominator = cross(along, back);
  if (denominator < 0) return {-cross(offset, back), -denominator};
  return {cross(offset, back), denominator};
}

}  // namespace

int orientation(Point a, Point b, Point c) {
  return turn(a, b, a, c);
}

int turn(Point a, Point b, Point c, Point d) {
  const Point first = b - a;
  const Point second = d - c;
  const Estimate e = difference_of_products(first.x, second.y, first.y, second.x);
  if (is_certain(e)) return sign(e.value);
  if (e.error == 0 && e.value == 0 && (first == Point{} || second == Point{})) return 0;
  const auto p = exact(std::array{a, b, c, d});
  return cross(p[1] - p[0], p[3] - p[2]).sign();
}

int agreement(Point a, Point b, Point c, Point d) {
  const Point first = b - a;
  const Point second = d - c;
  const Estimate e = difference_of_products(first.x, second.x, -first.y, second.y);
  if (is_certain(e)) return sign(e.value);
  const auto p = exact(std::array{a, b, c, d});
  return dot(p[1] - p[0], p[3] - p[2]).sign();
}

Station station(const Segment& base, const Segment& mark) {
  const Point along = base.end - base.start;
  const Point offset = mark.start - base.start;
  const Point back = mark.start - mark.end;
  const bool is_foot = mark.start == mark.end;
  const Estimate den = is_foot ? difference_of_products(along.x, along.x, -along.y, along.y)
                               : difference_of_products(along.x, back.y, back.x, along.y);
  const Estimate num = is_foot ? difference_of_products(offset.x, along.x, -offset.y, along.y)
                               : difference_of_products(offset.x, back.y, back.x, offset.y);
  const double value = num.value / den.value;
  if (!is_certain(den)) return {value, std::numeric_limits<double>::infinity()};
  const double spread = (num.error + std::fabs(value) * den.error) / (std::fabs(den.value) - den.error);
  return {value, (1 + 8 * kUnit) * (spread + 2 * kUnit * std::fabs(value))};
}

Station exact_station(const Segment& base, const Segment& mark) {
  const Quotient q = station_quotient(base, mark);
  const auto value = boost::multiprecision::cpp_rational(q.numerator, q.denominator).convert_to<double>();
  return {value, 2 * kUnit * std::fabs(value)};
}

bool is_order_certain(Station a, Station b) {
  // Twice the sum covers the rounding of the sum and of the difference.
  return std::fabs(a.value - b.value) > 2 * (a.error + b.error);
}

int compare_stations(const Segment& base, const Segment& a, const Segment& b) {
  if (a == b) return 0;
  const Quotient p = station_quotient(base, a);
  const Quotient q = station_quotient(base, b);
  const Integer left = p.numerator * q.denominator;
  const Integer right = q.numerator * p.denominator;
  return left.compare(right) < 0 ? -1 : left.compare(right) > 0 ? 1 : 0;
}

}  // namespace keyblock
