// Computes the equilibrium of the fixed bodies of a scene by linear elasticity, and the rate at which Shi's static
// steps approach it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "legacy/contact/judge.hpp"
#include "legacy/step/advance.hpp"

namespace keyblock::support {

/// Linearised at the initial state. Bodies with fewer than two fixed points, and all contacts, are left out.
struct HeldStatics {
  int bodies = 0;
  int held_bodies = 0;
  std::vector<bool> is_held;  ///< of each element
  Increments increments;      ///< of the equilibrium; zero for elements that are not fixed
  double omega = 0;           ///< smallest circular frequency of the fixed bodies
  double greatest_displacement = 0;
  double least_stress_yy = 0;
  double greatest_stress_yy = 0;

  /// (1 + (ω dt)²/2)^-m: part of the lowest mode that is left after m steps, each begun at rest.
  double remaining_share(double dt, int steps) const;
};

/// `spring`: stiffness of a fixed point, force / length.
HeldStatics held_statics(ShiScene scene, double spring);

/// Displacement of a carried point by `increments`.
Point displacement_of(const ShiScene& scene, const Increments& increments, const CarriedPoint& point);

}  // namespace keyblock::support
