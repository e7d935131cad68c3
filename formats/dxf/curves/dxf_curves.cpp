// Computes chords of arcs; see dxf_curves.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/curves/dxf_curves.hpp"

#include <algorithm>
#include <cmath>

namespace keyblock::formats {

int chord_count(double sweep) {
  // The distance of a chord of angle a from its arc is r (1 - cos(a / 2)). The margin keeps a full circle at 32 chords.
  const double greatest_angle = 2 * std::acos(1 - kSagittaRatio);
  return std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / greatest_angle - 1e-9)));
}

std::vector<Point> arc_points(Point centre, double radius, double start, double sweep) {
  return ellipse_points(centre, {radius, 0}, {0, radius}, start, sweep);
}

std::vector<Point> ellipse_points(Point centre, Point major, Point minor, double start, double sweep) {
  const int chords = chord_count(sweep);
  std::vector<Point> points;
  for (int i = 0; i <= chords; ++i) {
    const double angle = start + sweep * i / chords;
    points.push_back(centre + (std::cos(angle) * major + std::sin(angle) * minor));
  }
  return points;
}

std::vector<Point> bulge_points(Point start, Point end, double bulge) {
  if (bulge == 0) return {};
  const double sweep = 4 * std::atan(bulge);
  // The centre lies left of the chord, at (1 - b²) / (4 b) of its length: r cos(sweep / 2) with r = c / (2 sin(sweep /
  // 2)).
  const Point chord = end - start;
  const Point centre = start + 0.5 * chord + ((1 - bulge * bulge) / (4 * bulge)) * Point{-chord.y, chord.x};
  const Point arm = start - centre;
  const int chords = chord_count(sweep);
  std::vector<Point> points;
  for (int i = 1; i < chords; ++i) {
    const double turn = sweep * i / chords;
    const double c = std::cos(turn), s = std::sin(turn);
    points.push_back(centre + Point{c * arm.x - s * arm.y, s * arm.x + c * arm.y});
  }
  return points;
}

}  // namespace keyblock::formats
