// All forces on bodies on covers together, by where they come from.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/point.hpp"

namespace keyblock {

/// Forces summed, and their moment about the origin (counter-clockwise).
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

/// The forces on all bodies together and their moments about the origin: they add up to nothing.
struct ForceBalance {
  Resultant loads;
  Resultant springs;
  std::vector<Resultant> supports;  ///< one a prescribed displacement

  /// What is left of all forces, over the largest of them; where there is none, what is left.
  double unbalanced() const;
};

}  // namespace keyblock
