// Decides exactly on which side points and directions lie, and the order of crossings along a line. It uses a
// floating-point filter first, and exact integers if the filter cannot decide.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/point.hpp"

namespace keyblock {

/// Returns the sign of the turn a → b → c: 1 to the left, -1 to the right, 0 straight. Exact.
int orientation(Point a, Point b, Point c);

/// Returns the sign of (b - a) × (d - c): 1 if the second direction turns to the left of the first. Exact.
int turn(Point a, Point b, Point c, Point d);

/// Returns the sign of (b - a) · (d - c). Exact.
int agreement(Point a, Point b, Point c, Point d);

/// Place of a mark along a base line: t in start + t (end - start), and a bound of the error of `value`.
struct Station {
  double value = 0;
  double error = 0;
};

/// Returns the station at which `base` crosses the straight line of `mark`; if both ends of `mark` are equal, that of
/// the foot of the point. `value` is evaluated as in Shi's programs: t = d1 / d0 with d0 = x21 y34 - x34 y21, d1 = x31
/// y34 - x34 y31.
Station station(const Segment& base, const Segment& mark);

/// Returns the station correctly rounded, for marks almost along the base, where the bound of `station` is infinite.
Station exact_station(const Segment& base, const Segment& mark);

/// Returns true if the bounds alone decide which of two stations comes first.
bool is_order_certain(Station a, Station b);

/// Returns the exact order of two marks along a base line: -1, 0 or 1.
int compare_stations(const Segment& base, const Segment& a, const Segment& b);

}  // namespace keyblock
