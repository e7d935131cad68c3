// Arcs and ellipses of a DXF file as chords.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/point.hpp"

namespace keyblock::formats {

/// Greatest distance of a chord from its arc, over the radius: 32 chords a full circle.
inline constexpr double kSagittaRatio = 0.005;

/// Chords of equal angle that an arc of this sweep (radians, either sign) takes; at least 1.
int chord_count(double sweep);

/// The end points of the chords of an arc, from `start` radians on; both ends of the arc are among them.
std::vector<Point> arc_points(Point centre, double radius, double start, double sweep);

/// The end points of the chords of an elliptic arc, from `start` on: centre + cos(t) major + sin(t) minor.
/// None leaves its curve by more than kSagittaRatio of the greater half axis.
std::vector<Point> ellipse_points(Point centre, Point major, Point minor, double start, double sweep);

/// The points strictly between the ends of a bulged side: bulge = tan(sweep / 4), positive counter-clockwise.
std::vector<Point> bulge_points(Point start, Point end, double bulge);

}  // namespace keyblock::formats
