// Finds corners that open into the rock, and how fast stress grows towards them without limit.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "problem/manifold.hpp"

namespace keyblock {

/// Corner of the boundary where rock occupies more than a half plane.
struct RockCorner {
  Point at;
  int element = 0;   ///< of the manifold; it has the corner
  double order = 0;  ///< stress grows as r^-order towards it
};

/// Returns the order of the stress at a corner with free faces and this angle of rock [rad]. It is 1 - λ with the least
/// root of sin λω + λ sin ω = 0, the opening mode (Williams 1952): 0 up to π, 0.4555 at 3π/2, 0.5 at 2π.
double stress_order(double angle);

/// Returns corners of outlines, holes and joints with an order above 0. Ends of cracks do not count.
std::vector<RockCorner> rock_corners(const Manifold& manifold);

}  // namespace keyblock
