// Points at the middles of parts, pulls that fall with their work; see parting_faces.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/parting_faces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/box.hpp"
#include "geometry/polygon.hpp"

namespace keyblock {
namespace {

constexpr int kPoints = 12;  // of a piece: tip_side is a sixteenth of an increment unless the case says otherwise
// What of the square of the pull goes at once: a force of 1 % less than under just the toughness.
constexpr double kGoesAtOnce = 0.02;
// Of the energy: what is left of it is nothing, and the faces have parted.
constexpr double kParted = 1e-4;
// Over the opening that a tip at its toughness has behind it as far as the piece is long, 8 K/E' √(l/2π), by which
// faces that pulled each other have taken their energy.
constexpr double kWide = 4;
// Of the length of a piece: how far beside it an element is looked for.
constexpr double kBesideFace = 1e-6;

bool is_in(const Manifold& manifold, std::size_t e, Point p) {
  Box box;
  for (const ElementCorner& corner : manifold.loop(manifold.elements[e].outer)) box.add(corner.position);
  if (!box.holds(p)) return false;
  const auto loops = manifold.polygon(manifold.elements[e]);
  return side(loops.front(), p) != Side::outside &&
         std::none_of(loops.begin() + 1, loops.end(), [&](const auto& hole) { return side(hole, p) == Side::inside; });
}

int element_at(const Manifold& manifold, Point p) {
  for (std::size_t e = 0; e < manifold.elements.size(); ++e)
    if (is_in(manifold, e, p)) return static_cast<int>(e);
  return -1;
}

Point opening_at(const PartingPoint& point, const std::function<Point(int, Point)>& displacement) {
  return displacement(point.left, point.at) - displacement(point.right, point.at);
}

bool lies_wide_open(const PartingFaces& faces) {
  return std::ranges::all_of(faces.points,
                             [&](const PartingPoint& p) { return p.left < 0 || length(p.apart) > faces.wide; });
}

}  // namespace

PartingFaces parting_faces(Point from, Point to, double energy, double modulus, Point along,
                           const std::function<Point(Point)>& traction) {
  // With K = √(E' Γ/l).
  const double wide = kWide * 8 * std::sqrt(energy / modulus / (2 * std::numbers::pi));
  PartingFaces faces{from, to, energy, wide, 0, std::sqrt(1 - kGoesAtOnce)};
  const double part = distance(from, to) / kPoints;
  const Point direction = (1 / length(along)) * along;
  const Point out{direction.y, -direction.x};  // of the left face
  for (int i = 0; i < kPoints; ++i) {
    const Point at = from + ((i + 0.5) / kPoints) * (to - from);
    Point pull = part * traction(at);
    if (const double normal = dot(pull, out); normal < 0) pull = pull - normal * out;
    faces.points.push_back({at, pull});
  }
  return faces;
}

void put_elements(PartingFaces& faces, const Manifold& manifold) {
  const Point along = faces.to - faces.from;
  const Point left = kBesideFace * Point{-along.y, along.x};
  for (PartingPoint& point : faces.points) {
    point.left = element_at(manifold, point.at + left);
    point.right = element_at(manifold, point.at - left);
    if (point.left < 0 || point.right < 0) point.left = point.right = -1;
  }
}

void let_go(PartingFaces& faces, const std::function<Point(int, Point)>& displacement) {
  for (PartingPoint& point : faces.points) {
    if (point.left < 0) continue;
    const Point apart = opening_at(point, displacement);
    faces.taken -= faces.share * dot(point.pull, apart - point.apart);
    point.apart = apart;
  }
  const double left = 1 - faces.taken / faces.energy;
  const bool holds = left > kParted && !lies_wide_open(faces);
  faces.share = holds ? std::min(faces.share, std::sqrt((1 - kGoesAtOnce) * left)) : 0;
}

void look_at_openings(PartingFaces& faces, const std::function<Point(int, Point)>& displacement) {
  for (PartingPoint& point : faces.points)
    if (point.left >= 0) point.apart = opening_at(point, displacement);
}

}  // namespace keyblock
