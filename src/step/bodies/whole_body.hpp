// What is known of a body without its strain.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "geometry/point.hpp"

namespace keyblock {

/// A body seen as a rigid one.
struct WholeBody {
  double mass = 0;
  double inertia = 0;  ///< about the mass centre, as it is now
  double size = 0;     ///< largest distance of a vertex from the mass centre at the start
  Point centre;        ///< mass centre now
  /// Of forces, or momenta, on the unknowns: x, y and moment about the mass centre; and the sum of their sizes.
  Eigen::Vector3d resultant = Eigen::Vector3d::Zero();
  double gross = 0;
};

}  // namespace keyblock
