// The functions of which the displacement near a crack tip is made.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "geometry/point.hpp"

namespace keyblock {

/// Axes at a tip: x ahead, y to its left.
struct TipAxes {
  Point at;
  Point ahead;  ///< of length 1

  /// From straight ahead, -π to π.
  double angle_to(Point x) const;
};

/// √r {cos θ/2, sin θ/2, cos 3θ/2, sin 3θ/2} (Williams 1957; the span of the four of Belytschko & Black 1999), r the
/// distance from the tip, θ the angle from straight ahead: continued from where it is `middle`, less than half a turn
/// to either side. Taken for both components of the displacement they are a space that turns with the body: {field of
/// mode I, of mode II} is none.
struct NearTipValues {
  Eigen::RowVector4d values;
  Eigen::Matrix<double, 2, 4> gradients;  ///< ∂/∂x, ∂/∂y of the plane; not finite at the tip
};

Eigen::RowVector4d near_tip_functions(const TipAxes& tip, double middle, Point x);
NearTipValues near_tip_values(const TipAxes& tip, double middle, Point x);

/// An angle brought into -π to π.
double half_turn(double angle);

}  // namespace keyblock
