// Splines of a DXF file as chords.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/point.hpp"

namespace keyblock::formats {

/// Greatest distance of a chord from its spline, over the size of the spline (the diagonal of the box about its
/// points). A piece between two knots has at most kMostChords chords.
inline constexpr double kSplineRatio = 0.001;
inline constexpr int kMostChords = 1024;
inline constexpr int kMostDegree = 25;

/// A NURBS curve (Piegl & Tiller 1997, The NURBS Book). `weights`: one per control point, or none: all are 1.
struct Nurbs {
  int degree = 3;
  std::vector<double> knots;
  std::vector<Point> controls;
  std::vector<double> weights = {};
};

/// Returns true if there are degree + 1 control points at least, controls + degree + 1 knots that do not fall, a piece
/// between the first and the last that is not empty, and weights above 0.
bool is_sound(const Nurbs& curve);

/// The point at a parameter between the first and the last knot of the curve, by the algorithm of de Boor.
Point point_at(const Nurbs& curve, double parameter);

/// The ends of the chords, both ends of the curve among them.
std::vector<Point> spline_points(const Nurbs& curve);

/// The cubic spline through points, with chord lengths as parameters: its second derivative is continuous, and 0 at
/// both ends. Two points give a straight line.
Nurbs spline_through(const std::vector<Point>& points);

}  // namespace keyblock::formats
