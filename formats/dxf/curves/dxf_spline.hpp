// Converts splines of a DXF file to chords.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/point.hpp"

namespace keyblock::formats {

/// Greatest distance of a chord from its spline, over the size of the spline (the diagonal of the bounding box of its
/// points). A piece between two knots has at most kMostChords chords.
inline constexpr double kSplineRatio = 0.001;
inline constexpr int kMostChords = 1024;
inline constexpr int kMostDegree = 25;

/// NURBS curve (Piegl & Tiller 1997, The NURBS Book). `weights`: one per control point, or empty: all are 1.
struct Nurbs {
  int degree = 3;
  std::vector<double> knots;
  std::vector<Point> controls;
  std::vector<double> weights = {};
};

/// Returns true if the curve has at least degree + 1 control points, controls + degree + 1 knots that do not decrease,
/// and weights above 0. The piece between its first and last knot must not be empty.
bool is_sound(const Nurbs& curve);

/// Returns the point at a parameter between the first and the last knot of the curve, by the algorithm of de Boor.
Point point_at(const Nurbs& curve, double parameter);

/// Returns the ends of the chords, with both ends of the curve.
std::vector<Point> spline_points(const Nurbs& curve);

/// Returns the cubic spline through points, with chord lengths as parameters. Its second derivative is continuous, and
/// 0 at both ends. Two points give a straight line.
Nurbs spline_through(const std::vector<Point>& points);

}  // namespace keyblock::formats
