// Outlines of scenes: a rectangle, a slope, and the sections of tunnels in them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/error.hpp"
#include "geometry/point.hpp"

namespace keyblock {

/// A closed chain of corners, counter-clockwise, the first not repeated.
using Outline = std::vector<Point>;

/// (x, y) is the lower left corner.
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
  circle,     ///< an ellipse where width and height differ
  d,          ///< half a circle on upright walls
  horseshoe,  ///< half a circle on walls that are arcs of the radius `width` about the opposite springing; level floor
};

/// A tunnel of this width and height; (x, y) is the middle of both.
struct TunnelSection {
  TunnelShape shape = TunnelShape::circle;
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
  Place place;
};

/// Arcs of tunnels are drawn with so many chords a full circle.
inline constexpr int kChordsOfCircle = 32;

Outline outline_of(const RectangleShape& shape);
Outline outline_of(const SlopeShape& shape);

/// Throws InputError where a D is lower than half its width, or a horseshoe lower than that or so high that its walls
/// would meet (√3/2 of the width below the springing).
Outline outline_of(const TunnelSection& tunnel);

}  // namespace keyblock
