// Generates outlines of scenes: a rectangle, a slope, and sections of tunnels in them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/error.hpp"
#include "geometry/point.hpp"

namespace keyblock {

/// Closed chain of corners, counter-clockwise, the first not repeated.
using Outline = std::vector<Point>;

/// Rectangle; (x, y) is the lower left corner.
struct RectangleShape {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
};

/// Ground that rises to the right. (x, y) is the foot of the face. The face rises `height` in `benches` equal lifts,
/// each at `angle_deg` (above 0, 90 at most), with level benches of width `bench` between them.
struct SlopeShape {
  double x = 0;
  double y = 0;
  double height = 0;
  double angle_deg = 0;
  double bench = 0;
  int benches = 1;
  double toe = 0;    ///< level ground before the foot
  double crest = 0;  ///< level ground behind the top
  double base = 0;   ///< rock below the foot
};

enum class TunnelShape {
  circle,     ///< an ellipse if width and height differ
  d,          ///< half a circle on upright walls
  horseshoe,  ///< half a circle on walls that are arcs of the radius `width` about the opposite springing; level floor
};

/// Tunnel of this width and height; (x, y) is the middle of both.
struct TunnelSection {
  TunnelShape shape = TunnelShape::circle;
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
  Place place;
};

/// Chords per full circle in the arcs of tunnels.
inline constexpr int kChordsOfCircle = 32;

Outline outline_of(const RectangleShape& shape);
Outline outline_of(const SlopeShape& shape);
inline Outline outline_of(const Outline& corners) {
  return corners;
}

/// Returns the outline. Throws InputError if a D is lower than half its width. Throws it if a horseshoe is lower than
/// that, or so high that its walls would meet (√3/2 of the width below the springing).
Outline outline_of(const TunnelSection& tunnel);

}  // namespace keyblock
