// What the held bodies of a scene would come to by linear elasticity alone, and how fast static steps of the old kind
// go there.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "legacy/contact/judge.hpp"
#include "legacy/step/advance.hpp"

namespace keyblock::support {

/// Linear about the start; bodies held in fewer than two points, and all contact, are left out.
struct HeldStatics {
  int bodies = 0;
  int held_bodies = 0;
  std::vector<bool> is_held;  ///< of each element
  Increments increments;      ///< of the equilibrium; zero for elements that are not held
  double omega = 0;           ///< smallest circular frequency of the held bodies
  double greatest_displacement = 0;
  double least_stress_yy = 0;
  double greatest_stress_yy = 0;

  /// (1 + (ω dt)²/2)^-m: what m steps that start from rest leave of the lowest mode.
  double remaining_share(double dt, int steps) const;
};

/// `spring`: stiffness of a fixed point, force / length.
HeldStatics held_statics(ShiScene scene, double spring);

/// Displacement of a carried point by `increments`.
Point displacement_of(const ShiScene& scene, const Increments& increments, const CarriedPoint& point);

}  // namespace keyblock::support
