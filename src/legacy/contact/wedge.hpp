// The angular wedge of material at a vertex, and whether two wedges may touch. Angles in degrees, 0 … 360.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/point.hpp"

namespace keyblock {

/// Brings an angle that is at most one turn off into 0 … 360.
double one_turn(double degrees);

/// Direction of `edge`, 0 … 360. `offset` (length) is added to |dx|: the Berkeley program's 1e-7, else 0
/// (legacy-rules 3).
double edge_direction(Point edge, double offset);

/// Material lies from direction `from` (towards the next vertex) counter-clockwise to `to` (towards the
/// previous one).
struct Wedge {
  double from = 0;
  double to = 0;

  double angle() const { return to - from < 0 ? to - from + 360 : to - from; }
};

/// Neither of the two wedges reaches into the other by more than `overlap`.
bool may_touch(const Wedge& a, const Wedge& b, double overlap);

}  // namespace keyblock
