// Converts arcs and ellipses of a DXF file to chords.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/point.hpp"

namespace keyblock::formats {

/// Greatest distance of a chord from its arc, over the radius: 32 chords per full circle.
inline constexpr double kSagittaRatio = 0.005;

/// Returns the number of chords of equal angle for an arc of this sweep (radians, either sign); at least 1.
int chord_count(double sweep);

/// Returns the end points of the chords of an arc, from `start` radians on, with both ends of the arc.
std::vector<Point> arc_points(Point centre, double radius, double start, double sweep);

/// Returns the end points of the chords of an elliptic arc, from `start` on: centre + cos(t) major + sin(t) minor. The
/// distance of each chord from its curve is at most kSagittaRatio of the greater half axis.
std::vector<Point> ellipse_points(Point centre, Point major, Point minor, double start, double sweep);

/// Returns the points strictly between the ends of a bulged side: bulge = tan(sweep / 4), positive counter-clockwise.
std::vector<Point> bulge_points(Point start, Point end, double bulge);

}  // namespace keyblock::formats
