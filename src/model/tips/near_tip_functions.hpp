// Evaluates the functions that span the displacement near a crack tip.
// Theory: docs/theory/10-fracture.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "geometry/point.hpp"

namespace keyblock {

/// Axes at a tip: x ahead, y to its left.
struct TipAxes {
  Point at;
  Point ahead;  ///< of length 1

  /// Returns the angle from straight ahead, -π to π.
  double angle_to(Point x) const;
};

/// Values of √r {cos θ/2, sin θ/2, cos 3θ/2, sin 3θ/2} (Williams 1957; the span of the four of Belytschko & Black
/// 1999). r is the distance from the tip, θ the angle from straight ahead. θ is continued from the angle `middle`, less
/// than half a turn to either side. Used for both components of the displacement, they span a space that rotates with
/// the body; the fields of mode I and mode II alone do not.
struct NearTipValues {
  Eigen::RowVector4d values;
  Eigen::Matrix<double, 2, 4> gradients;  ///< ∂/∂x, ∂/∂y of the plane; not finite at the tip
};

Eigen::RowVector4d near_tip_functions(const TipAxes& tip, double middle, Point x);
NearTipValues near_tip_values(const TipAxes& tip, double middle, Point x);

/// Returns the angle shifted into -π to π.
double half_turn(double angle);

}  // namespace keyblock
