// Interpolates a vector linearly in time between given rows: loads of points, motions of fixed points, accelerations.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/error.hpp"
#include "geometry/point.hpp"

namespace keyblock {

/// Rows (t, value), times strictly increasing. An empty curve is always zero.
struct TimeCurve {
  std::vector<double> times;
  std::vector<Point> values;  ///< force (loading point), displacement (fixed point) or acceleration
  Place place;

  /// Returns the value, linear between rows (legacy-rules 7.3); before the first and after the last row it is that of
  /// the nearest row.
  Point at(double time) const;

  /// Returns the time from which the value stays the same; 0 if it never changes.
  double last_change() const;
};

}  // namespace keyblock
