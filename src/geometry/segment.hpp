// Tests if two straight pieces meet, and computes their distance.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace keyblock {

/// Returns the point of the segment at start + t (end - start).
Point point_at(const Segment& segment, double t);

/// Returns t of the foot of the perpendicular from `p`; outside 0..1 the foot lies beyond the ends of the segment.
double foot(const Segment& segment, Point p);

/// Returns the distance from `p` to the nearest point of the segment.
double distance(const Segment& segment, Point p);

/// Returns the distance from `p` to the straight line through the segment.
double distance_to_carrier(const Segment& segment, Point p);

/// Meeting of two segments, decided exactly. `crossing`: in one point and not along each other (an end may touch);
/// `overlapping`: on one straight line with at least one common point.
enum class Meeting { none, crossing, overlapping };

Meeting meeting(const Segment& a, const Segment& b);

/// Returns the parts of `segment` along which one of `others` runs, in order, joined if they overlap or meet. "Along"
/// is within `near` on the whole of the common part. Parts no longer than the rounding of coordinates are left out. A
/// part that ends within that rounding of an end of `segment` ends at it, to the bit.
std::vector<Segment> parts_along(const Segment& segment, std::span<const Segment> others, double near);

}  // namespace keyblock
