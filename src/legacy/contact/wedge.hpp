// Represents the angular wedge of material at a vertex and tests contact of two wedges. Angles in degrees, 0 … 360.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/point.hpp"

namespace keyblock {

/// Returns the angle in 0 … 360; it may be outside by at most one turn.
double one_turn(double degrees);

/// Returns the direction of `edge`, 0 … 360. `offset` (length) is added to |dx|: 1e-7 in the Berkeley program, else 0
/// (legacy-rules 3).
double edge_direction(Point edge, double offset);

/// Wedge of material from direction `from` (towards the next vertex) counter-clockwise to `to` (towards the previous
/// one).
struct Wedge {
  double from = 0;
  double to = 0;

  double angle() const { return to - from < 0 ? to - from + 360 : to - from; }
};

/// Returns true if neither wedge reaches into the other by more than `overlap`.
bool may_touch(const Wedge& a, const Wedge& b, double overlap);

}  // namespace keyblock
