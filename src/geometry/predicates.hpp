// Decides on which side points and directions lie, and in which order crossings stand along a line,
// without error: a floating-point filter first, exact integers where the filter cannot tell.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/point.hpp"

namespace keyblock {

/// Sign of the turn a → b → c: 1 to the left, -1 to the right, 0 straight. Exact.
int orientation(Point a, Point b, Point c);

/// Sign of (b - a) × (d - c): 1 if the second direction turns to the left of the first. Exact.
int turn(Point a, Point b, Point c, Point d);

/// Sign of (b - a) · (d - c). Exact.
int agreement(Point a, Point b, Point c, Point d);

/// Where along a base line a mark stands: t in start + t (end - start), and a bound of the error of `value`.
struct Station {
  double value = 0;
  double error = 0;
};

/// Station of the crossing of `base` with the carrier of `mark`; where both ends of `mark` are equal, of the
/// foot of that point. `value` is evaluated as the old programs do: t = d1 / d0 with d0 = x21 y34 - x34 y21,
/// d1 = x31 y34 - x34 y31.
Station station(const Segment& base, const Segment& mark);

/// The same correctly rounded, for marks almost along the base, where the bound of `station` is infinite.
Station exact_station(const Segment& base, const Segment& mark);

/// Do the bounds alone tell which of two stations comes first?
bool is_order_certain(Station a, Station b);

/// Exact order of two marks along a base line: -1, 0 or 1.
int compare_stations(const Segment& base, const Segment& a, const Segment& b);

}  // namespace keyblock
