// Computes the corners of outlines; the header describes the shapes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

using std::numbers::pi;

/// Appends points of an ellipse from angle `first` to `last`, both included.
void add_arc(Outline& outline, Point centre, Point radii, double first, double last, int chords) {
  for (int i = 0; i <= chords; ++i) {
    const double angle = first + (last - first) * i / chords;
    outline.push_back(centre + Point{radii.x * std::cos(angle), radii.y * std::sin(angle)});
  }
}

Outline circle(const TunnelSection& t) {
  Outline outline;
  add_arc(outline, {t.x, t.y}, {t.width / 2, t.height / 2}, 0, 2 * pi, kChordsOfCircle);
  outline.pop_back();
  return outline;
}

void require_height(const TunnelSection& t, double least, double most) {
  if (t.height > least && t.height < most) return;
  throw InputError(t.place,
                   fmt::format("expected a tunnel of this width higher than {:.6g} and lower than {:.6g}, found "
                               "height {:.6g}",
                               least, most, t.height));
}

Outline d_shape(const TunnelSection& t) {
  const double r = t.width / 2;
  require_height(t, r, HUGE_VAL);
  const double floor = t.y - t.height / 2;
  Outline outline{{t.x - r, floor}, {t.x + r, floor}};
  add_arc(outline, {t.x, t.y + t.height / 2 - r}, {r, r}, 0, pi, kChordsOfCircle / 2);
  return outline;
}

Outline horseshoe(const TunnelSection& t) {
  const double r = t.width / 2;
  require_height(t, r, r + std::sqrt(3.0) * r);
  const double springing = t.y + t.height / 2 - r;
  const double wall = std::asin((t.height - r) / t.width);  // angle of the wall's arc, of radius 2 r = width
  const int chords = std::max(1, static_cast<int>(std::ceil(wall / (2 * pi) * kChordsOfCircle)));
  Outline outline;
  add_arc(outline, {t.x - r, springing}, {t.width, t.width}, -wall, 0, chords);
  outline.pop_back();
  add_arc(outline, {t.x, springing}, {r, r}, 0, pi, kChordsOfCircle / 2);
  outline.pop_back();
  add_arc(outline, {t.x + r, springing}, {t.width, t.width}, pi, pi + wall, chords);
  return outline;
}

}  // namespace

Outline outline_of(const RectangleShape& s) {
  return {{s.x, s.y}, {s.x + s.width, s.y}, {s.x + s.width, s.y + s.height}, {s.x, s.y + s.height}};
}

Outline outline_of(const SlopeShape& s) {
  const double lift = s.height / s.benches;
  const double run = s.angle_deg == 90 ? 0 : lift / std::tan(s.angle_deg * pi / 180);
  Outline face;  // from the foot up
  Point at{s.x, s.y};
  for (int i = 1; i <= s.benches; ++i) {
    face.push_back(at);
    at = {at.x + run, s.y + s.height * i / s.benches};
    face.push_back(at);
    at.x += s.bench;
  }
  const Point top = face.back();
  Outline outline{{s.x - s.toe, s.y - s.base}, {top.x + s.crest, s.y - s.base}, {top.x + s.crest, top.y}};
  outline.insert(outline.end(), face.rbegin(), face.rend());
  outline.push_back({s.x - s.toe, s.y});
  const auto kept = std::unique(outline.begin(), outline.end());
  outline.erase(kept, outline.end());
  if (outline.front() == outline.back()) outline.pop_back();
  return outline;
}

Outline outline_of(const TunnelSection& tunnel) {
  switch (tunnel.shape) {
    case TunnelShape::d:
      return d_shape(tunnel);
    case TunnelShape::horseshoe:
      return horseshoe(tunnel);
    default:
      return circle(tunnel);
  }
}

}  // namespace keyblock
