// Splines and ellipses of DXF files: chords within the stated distance of the curve, compared with formulas.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/curves/dxf_spline.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "formats/dxf/curves/dxf_curves.hpp"
#include "formats/dxf/dxf.hpp"
#include "geometry/box.hpp"
#include "geometry/segment.hpp"
#include "tests/formats/dxf_samples.hpp"

namespace keyblock::formats::dxf_spline_test {
namespace {

/// Returns the largest distance of points of a curve from a chain of chords.
template <class Curve>
double deviation(const std::vector<Point>& chain, Curve curve) {
  double greatest = 0;
  for (int i = 0; i <= 20000; ++i) {
    double least = 1e300;
    const Point p = curve(i / 20000.0);
    for (std::size_t k = 0; k + 1 < chain.size(); ++k)
      least = std::min(least, distance(Segment{chain[k], chain[k + 1]}, p));
    greatest = std::max(greatest, least);
  }
  return greatest;
}

double size_of(const std::vector<Point>& points) {
  Box box;
  for (const Point p : points) box.add(p);
  return length(box.size());
}

std::vector<double> clamped_knots(int degree, std::size_t controls) {
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
  const std::size_t inner = controls - static_cast<std::size_t>(degree) - 1;
  for (std::size_t i = 1; i <= inner; ++i) knots.push_back(double(i) / double(inner + 1));
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, 1.0);
  return knots;
}

/// Recursion of Cox and de Boor, basis function by basis function.
double basis(const std::vector<double>& knots, std::size_t i, int degree, double t) {
  if (degree == 0) return t >= knots[i] && (t < knots[i + 1] || (t == 1 && knots[i] < 1 && knots[i + 1] == 1)) ? 1 : 0;
  const auto p = static_cast<std::size_t>(degree);
  const double left = knots[i + p] - knots[i], right = knots[i + p + 1] - knots[i + 1];
  return (left > 0 ? (t - knots[i]) / left * basis(knots, i, degree - 1, t) : 0) +
         (right > 0 ? (knots[i + p + 1] - t) / right * basis(knots, i + 1, degree - 1, t) : 0);
}

std::vector<Point> points_of_drawing(const std::string& entities) {
  const Reading reading = kDxf.read({"f", dxf_text(entities)}, {});
  std::vector<Point> points;
  for (const JointLine& joint : reading.content.drawing->joints) points.push_back(joint.segment.start);
  if (!points.empty()) points.push_back(reading.content.drawing->joints.back().segment.end);
  return points;
}

}  // namespace

// A quarter of a circle as a rational parabola: The NURBS Book, section 7.3.
TEST(DxfSpline, a_rational_parabola_is_a_quarter_of_a_circle) {
  const Nurbs quarter{2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {1, 1}, {0, 1}}, {1, std::sqrt(0.5), 1}};
  ASSERT_TRUE(is_sound(quarter));
  for (int i = 0; i <= 100; ++i) EXPECT_NEAR(length(point_at(quarter, i / 100.0)), 1, 1e-14);
  const std::vector<Point> chain = spline_points(quarter);
  EXPECT_EQ(chain.front(), (Point{1, 0}));
  EXPECT_EQ(chain.back(), (Point{0, 1}));
  const auto arc = [](double t) {
    return Point{std::cos(t * std::numbers::pi / 2), std::sin(t * std::numbers::pi / 2)};
  };
  EXPECT_LE(deviation(chain, arc), kSplineRatio * size_of(quarter.controls));
}

TEST(DxfSpline, chords_leave_random_splines_by_no_more_than_the_stated_share_of_their_size) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int n = 0; n < 40; ++n) {
    Nurbs curve;
    curve.degree = 1 + n % 6;
    const std::size_t controls = static_cast<std::size_t>(curve.degree) + 1 + static_cast<std::size_t>(n % 5);
    for (std::size_t i = 0; i < controls; ++i) curve.controls.push_back({10 * share(random), share(random)});
    curve.knots = clamped_knots(curve.degree, controls);
    if (n % 2 == 1)
      for (std::size_t i = 0; i < controls; ++i) curve.weights.push_back(1.5 + share(random));
    const auto exact = [&](double t) {
      Point sum;
      double weights = 0;
      for (std::size_t i = 0; i < controls; ++i) {
        const double w = (curve.weights.empty() ? 1 : curve.weights[i]) * basis(curve.knots, i, curve.degree, t);
        sum = sum + w * curve.controls[i];
        weights += w;
      }
      return (1 / weights) * sum;
    };
    EXPECT_LE(deviation(spline_points(curve), exact), kSplineRatio * size_of(curve.controls)) << n;
  }
}

TEST(DxfSpline, a_spline_through_points_passes_them_and_is_straight_through_two) {
  const std::vector<Point> points{{0, 0}, {2, 1}, {3, -1}, {7, 0}};
  const std::vector<Point> chain = spline_points(spline_through(points));
  for (const Point p : points) {
    double least = 1e300;
    for (const Point q : chain) least = std::min(least, distance(p, q));
    EXPECT_LT(least, 1e-12);
  }
  EXPECT_EQ(spline_points(spline_through({{0, 0}, {4, 2}})).size(), 3U) << "two chords along one line";
  EXPECT_NEAR(deviation(spline_points(spline_through({{0, 0}, {4, 2}})),
                        [](double t) {
                          return Point{4 * t, 2 * t};
                        }),
              0, 1e-12);
}

// The natural spline through samples of a cubic whose second derivative vanishes at both ends is that cubic.
TEST(DxfSpline, the_spline_through_points_on_a_line_keeps_their_line) {
  const Nurbs curve = spline_through({{0, 0}, {1, 3}, {3, 9}, {4, 12}});
  for (int i = 0; i <= 50; ++i) {
    const Point p = point_at(curve, curve.knots.back() * i / 50);
    EXPECT_NEAR(p.y, 3 * p.x, 1e-12);
  }
}

TEST(DxfSpline, an_ellipse_and_an_arc_of_one_keep_within_a_share_of_the_greater_half_axis) {
  const std::string head = "0\nELLIPSE\n8\nJOINT_1\n10\n2\n20\n1\n30\n0\n11\n3\n21\n4\n31\n0\n40\n0.4\n";
  const auto exact = [](double t) {  // half axes 5 and 2
    const Point major{3, 4}, minor{-1.6, 1.2};
    return Point{2, 1} + (std::cos(t) * major + std::sin(t) * minor);
  };
  const std::vector<Point> whole = points_of_drawing(head + "41\n0\n42\n6.28319\n");
  EXPECT_EQ(whole.front(), whole.back());
  EXPECT_EQ(whole.size(), 33U);
  EXPECT_LE(deviation(whole, [&](double t) { return exact(2 * std::numbers::pi * t); }), 5 * kSagittaRatio + 1e-12);
  const std::vector<Point> part = points_of_drawing(head + "41\n5.5\n42\n1\n");
  EXPECT_LE(deviation(part, [&](double t) { return exact(5.5 + (1 - 5.5 + 2 * std::numbers::pi) * t); }),
            5 * kSagittaRatio);
  EXPECT_LT(distance(part.front(), exact(5.5)), 1e-12);
  EXPECT_LT(distance(part.back(), exact(1)), 1e-12);
  const std::vector<Point> below = points_of_drawing(head + "210\n0\n220\n0\n230\n-1\n41\n0\n42\n1\n");
  EXPECT_LT(distance(below.back(), Point{2, 1} + (std::cos(1.0) * Point{3, 4} - std::sin(1.0) * Point{-1.6, 1.2})),
            1e-12);
}

TEST(DxfSpline, a_spline_that_is_none_is_skipped_and_said) {
  const std::string few = "0\nSPLINE\n8\nJOINT_1\n71\n3\n40\n0\n40\n1\n10\n0\n20\n0\n10\n1\n20\n1\n";
  const std::string line = "0\nLINE\n8\nJOINT_1\n10\n0\n20\n0\n11\n1\n21\n1\n";
  const Reading reading = kDxf.read({"f", dxf_text(few + line)}, {});
  ASSERT_EQ(reading.warnings.size(), 1U);
  EXPECT_EQ(reading.warnings[0].sentence, "skipped: 1 × SPLINE whose knots, points or weights make no curve");
  EXPECT_THROW(kDxf.read({"f", dxf_text("0\nSPLINE\n8\nJOINT_1\n71\n3\n10\n0\n10\n1\n20\n1\n")}, {}), InputError);
}

// Drawing programs write both; a closed spline ends where it begins.
TEST(DxfSpline, control_points_count_before_fit_points_and_fit_points_alone_are_enough) {
  const std::string knots = "40\n0\n40\n0\n40\n1\n40\n1\n";
  const std::string controls = "10\n0\n20\n0\n30\n0\n10\n4\n20\n2\n30\n0\n";
  const std::string fit = "11\n0\n21\n0\n31\n0\n11\n1\n21\n5\n31\n0\n11\n2\n21\n0\n31\n0\n";
  const std::vector<Point> by_controls = points_of_drawing("0\nSPLINE\n8\nJOINT_1\n71\n1\n" + knots + controls + fit);
  EXPECT_EQ(by_controls.back(), (Point{4, 2}));
  const std::vector<Point> by_fit = points_of_drawing("0\nSPLINE\n8\nJOINT_1\n71\n3\n" + fit);
  EXPECT_NEAR(by_fit.back().x, 2, 1e-12);
  const std::vector<Point> closed = points_of_drawing("0\nSPLINE\n8\nJOINT_1\n70\n1\n71\n3\n" + fit);
  EXPECT_EQ(closed.front(), closed.back());
}

}  // namespace keyblock::formats::dxf_spline_test
