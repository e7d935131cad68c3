// Sums all forces on NMM bodies by their source.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/point.hpp"

namespace keyblock {

/// Sum of forces, and of their moments about the origin (counter-clockwise).
struct Resultant {
  Point force;
  double moment = 0;

  void add(Point at, Point more) {
    force = force + more;
    moment += cross(at, more);
  }
  void add(const Resultant& more) {
    force = force + more.force;
    moment += more.moment;
  }
};

/// Forces on all bodies together and their moments about the origin, which should add up to zero.
struct ForceBalance {
  Resultant loads;
  Resultant springs;
  std::vector<Resultant> supports;  ///< one per prescribed displacement

  /// Returns the sum of all forces over the largest of them, or the sum itself if all are zero.
  double unbalanced() const;
};

}  // namespace keyblock
