// Computes distance and sliding of a vertex against its reference line: initial values of the step and their linear
// change.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/contact/contact.hpp"
#include "model/state.hpp"

namespace keyblock {

inline double sign(double x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

/// Triple with its three points. Distances are lengths, positive outside.
struct Line {
  Point p1, p2, p3;

  Point along() const { return p3 - p2; }
  double size() const { return length(along()); }
  /// Returns twice the area of (P1, P2, P3): distance × size.
  double twice_area() const { return cross(p2 - p1, p3 - p1); }
  double distance() const { return twice_area() / size(); }
  /// Returns the point of the line at `ratio` of the way from P2 to P3.
  Point at(double ratio) const { return (1 - ratio) * p2 + ratio * p3; }
  /// Returns the projection of P1 onto the line, 0 at P2 and 1 at P3.
  double projection() const { return dot(p1 - p2, along()) / dot(along(), along()); }
};

Line line_of(const State& state, const Triple& triple);

/// Displacements of the three points of a triple.
struct LineMotion {
  Point u1, u2, u3;
};

/// Returns the first-order change of `twice_area` under the motion, including the rotation of the line (Shi 1988,
/// normal contact).
inline double twice_area_change(const Line& l, const LineMotion& u) {
  return u.u1.x * (l.p2.y - l.p3.y) + u.u1.y * (l.p3.x - l.p2.x) + u.u2.x * (l.p3.y - l.p1.y) +
         u.u2.y * (l.p1.x - l.p3.x) + u.u3.x * (l.p1.y - l.p2.y) + u.u3.y * (l.p2.x - l.p1.x);
}

}  // namespace keyblock
