// Evaluates splines by de Boor's algorithm, halves chords, and computes the natural cubic spline; see dxf_spline.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/curves/dxf_spline.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

#include "geometry/box.hpp"
#include "geometry/segment.hpp"

namespace keyblock::formats {
namespace {

/// Point multiplied by its weight, and the weight.
struct Weighted {
  Point point;
  double weight = 1;
};

Weighted mixed(double share, const Weighted& a, const Weighted& b) {
  return {(1 - share) * a.point + share * b.point, (1 - share) * a.weight + share * b.weight};
}

/// Returns the piece between two knots that contains a parameter: the index of the knot before it.
std::size_t piece_of(const Nurbs& curve, double parameter) {
  const auto first = curve.knots.begin() + curve.degree;
  const auto last = curve.knots.begin() + static_cast<std::ptrdiff_t>(curve.controls.size());
  auto after = std::upper_bound(first, last, parameter);
  if (after == first) ++after;
  if (after == last && *last <= parameter) after = std::lower_bound(first, last, *last);  // the end of the last piece
  return static_cast<std::size_t>(after - curve.knots.begin()) - 1;
}

/// Computes the chords of one curve.
class Halving {
 public:
  explicit Halving(const Nurbs& curve) : curve_(curve) {
    Box box;
    for (const Point p : curve.controls) box.add(p);
    tolerance_ = kSplineRatio * length(box.size());
  }

  std::vector<Point> points() {
    const std::size_t end = curve_.controls.size();
    points_.push_back(point_at(curve_, curve_.knots[static_cast<std::size_t>(curve_.degree)]));
    for (std::size_t i = static_cast<std::size_t>(curve_.degree); i < end; ++i)
      if (curve_.knots[i] < curve_.knots[i + 1]) add_piece(curve_.knots[i], curve_.knots[i + 1]);
    return std::move(points_);
  }

 private:
  // A curve with a turning point within a piece may cross its chord: each piece begins with a part per possible turn.
  void add_piece(double from, double to) {
    const int parts = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(1, curve_.degree - 1))));
    for (int i = 0; i < parts; ++i) {
      const double a = from + (to - from) * i / parts;
      const double b = i + 1 == parts ? to : from + (to - from) * (i + 1) / parts;
      add(a, points_.back(), b, point_at(curve_, b), parts);
    }
  }

  void add(double a, Point at_a, double b, Point at_b, int parts) {
    const double middle = 0.5 * (a + b);
    if (parts >= kMostChords || middle <= a || middle >= b || is_near(a, b, {at_a, at_b})) {
      points_.push_back(at_b);
      return;
    }
    const Point between = point_at(curve_, middle);
    add(a, at_a, middle, between, 2 * parts);
    add(middle, between, b, at_b, 2 * parts);
  }

  bool is_near(double a, double b, const Segment& chord) const {
    constexpr std::array<double, 7> kShares{0.5, 0.25, 0.75, 0.125, 0.375, 0.625, 0.875};
    return std::ranges::all_of(
        kShares, [&](double share) { return distance(chord, point_at(curve_, a + share * (b - a))) <= tolerance_; });
  }

  const Nurbs& curve_;
  double tolerance_ = 0;
  std::vector<Point> points_;
};

/// Computes the slopes of the natural spline at its points: one tridiagonal system (Thomas).
std::vector<Point> slopes_at(const std::vector<Point>& points, const std::vector<double>& steps) {
  const std::size_t n = points.size();
  std::vector<double> upper(n, 0);
  std::vector<Point> slopes(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double before = i > 0 ? 1 / steps[i - 1] : 0;
    const double after = i + 1 < n ? 1 / steps[i] : 0;
    const Point rise_before = i > 0 ? before * before * (points[i] - points[i - 1]) : Point{};
    const Point rise_after = i + 1 < n ? after * after * (points[i + 1] - points[i]) : Point{};
    const double pivot = 2 * (before + after) - (i > 0 ? before * upper[i - 1] : 0);
    upper[i] = after / pivot;
    slopes[i] = (1 / pivot) * (3 * (rise_before + rise_after) - (i > 0 ? before * slopes[i - 1] : Point{}));
  }
  for (std::size_t i = n - 1; i-- > 0;) slopes[i] = slopes[i] - upper[i] * slopes[i + 1];
  return slopes;
}

}  // namespace

bool is_sound(const Nurbs& curve) {
  const auto degree = static_cast<std::size_t>(std::max(curve.degree, 0));
  const std::size_t controls = curve.controls.size();
  return curve.degree >= 1 && curve.degree <= kMostDegree && controls > degree &&
         curve.knots.size() == controls + degree + 1 && std::ranges::is_sorted(curve.knots) &&
         curve.knots[degree] < curve.knots[controls] &&
         (curve.weights.empty() || (curve.weights.size() == controls &&
                                    std::ranges::all_of(curve.weights, [](double weight) { return weight > 0; })));
}

Point point_at(const Nurbs& curve, double parameter) {
  const std::size_t piece = piece_of(curve, parameter);
  const auto degree = static_cast<std::size_t>(curve.degree);
  std::array<Weighted, kMostDegree + 1> row;
  for (std::size_t i = 0; i <= degree; ++i) {
    const std::size_t control = piece - degree + i;
    const double weight = curve.weights.empty() ? 1 : curve.weights[control];
    row[i] = {weight * curve.controls[control], weight};
  }
  for (std::size_t level = 1; level <= degree; ++level)
    for (std::size_t i = degree; i >= level; --i) {
      const double low = curve.knots[piece - degree + i];
      const double high = curve.knots[piece + i + 1 - level];
      row[i] = mixed((parameter - low) / (high - low), row[i - 1], row[i]);
    }
  return (1 / row[degree].weight) * row[degree].point;
}

std::vector<Point> spline_points(const Nurbs& curve) {
  return Halving(curve).points();
}

// Each piece is a Bézier curve: knots of multiplicity 3 between them.
Nurbs spline_through(const std::vector<Point>& points) {
  std::vector<double> steps;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) steps.push_back(distance(points[i], points[i + 1]));
  const std::vector<Point> slopes = slopes_at(points, steps);
  Nurbs curve;
  double at = 0;
  curve.knots.assign(4, at);
  curve.controls.push_back(points.front());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double third = steps[i] / 3;
    curve.controls.push_back(points[i] + third * slopes[i]);
    curve.controls.push_back(points[i + 1] - third * slopes[i + 1]);
    curve.controls.push_back(points[i + 1]);
    at += steps[i];
    curve.knots.insert(curve.knots.end(), 3, at);
  }
  curve.knots.push_back(at);
  return curve;
}

}  // namespace keyblock::formats
