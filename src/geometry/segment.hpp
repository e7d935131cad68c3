// What two straight pieces have to do with each other: do they meet, how far apart are they.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/point.hpp"

namespace keyblock {

/// The point of the segment at start + t (end - start).
Point point_at(const Segment& segment, double t);

/// t of the foot of the perpendicular from `p`; outside 0..1 the foot lies on the carrier only.
double foot(const Segment& segment, Point p);

/// Distance from `p` to the nearest point of the segment.
double distance(const Segment& segment, Point p);

/// Distance from `p` to the straight line through the segment.
double distance_to_carrier(const Segment& segment, Point p);

/// How two segments meet, decided exactly. `crossing`: in one point and not along each other (an end may
/// touch); `overlapping`: on one straight line with at least one common point.
enum class Meeting { none, crossing, overlapping };

Meeting meeting(const Segment& a, const Segment& b);

}  // namespace keyblock
