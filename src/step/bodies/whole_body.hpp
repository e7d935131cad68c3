// Holds the rigid-body properties and resultants of a body.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "geometry/point.hpp"

namespace keyblock {

/// Body treated as rigid.
struct WholeBody {
  double mass = 0;
  double inertia = 0;  ///< about the mass centre, in the current shape
  double size = 0;     ///< largest distance of a vertex from the initial mass centre
  Point centre;        ///< current mass centre
  /// Resultant of forces or momenta on the unknowns: x, y and moment about the mass centre. `gross`: sum of their
  /// sizes.
  Eigen::Vector3d resultant = Eigen::Vector3d::Zero();
  double gross = 0;
};

}  // namespace keyblock
