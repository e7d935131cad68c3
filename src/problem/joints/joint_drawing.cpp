// Clips traces to an outline and composes the drawing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/joints/joint_drawing.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polygon.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

// Tolerance per side, so that a trace through a corner does not slip between the two sides that meet there.
constexpr double kCornerShare = 1e-12;
// Length per trace below which a piece is rounding at a corner.
constexpr double kShortestPiece = 1e-9;

Segment side_of(const Outline& loop, std::size_t i) {
  return {loop[i], loop[i + 1 == loop.size() ? 0 : i + 1]};
}

/// Appends the places on the segment, 0 to 1, at which it meets the loop.
void add_crossings(std::vector<double>& shares, const Segment& segment, const Outline& loop) {
  const Point d = segment.end - segment.start;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Segment side = side_of(loop, i);
    const Point e = side.end - side.start;
    const double sine = cross(d, e);
    if (sine == 0) continue;
    const Point to_side = side.start - segment.start;
    const double at = cross(to_side, e) / sine, along_side = cross(to_side, d) / sine;
    if (along_side >= -kCornerShare && along_side <= 1 + kCornerShare && at > 0 && at < 1) shares.push_back(at);
  }
}

bool is_inside(Point p, const std::vector<Outline>& loops) {
  if (side(loops.front(), p) != Side::inside) return false;
  return std::all_of(loops.begin() + 1, loops.end(),
                     [&](const Outline& hole) { return side(hole, p) == Side::outside; });
}

bool meet(const Outline& a, const Outline& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (meeting(side_of(a, i), side_of(b, j)) != Meeting::none) return true;
  return false;
}

/// Returns the outline, then the tunnels.
std::vector<Outline> outlines_of(const JointScene& scene) {
  std::vector<Outline> loops{std::visit([](const auto& shape) { return outline_of(shape); }, scene.outline)};
  for (const TunnelSection& tunnel : scene.tunnels) {
    Outline loop = outline_of(tunnel);
    const bool is_apart = std::ranges::none_of(loops, [&](const Outline& other) { return meet(loop, other); });
    if (!is_apart || !is_inside(loop.front(), loops) ||
        std::any_of(loops.begin() + 1, loops.end(),
                    [&](const Outline& other) { return side(loop, other.front()) == Side::inside; }))
      throw InputError(tunnel.place,
                       "expected a tunnel inside the outline and apart from the others, found one that is not");
    loops.push_back(std::move(loop));
  }
  return loops;
}

/// Returns the middle of the box around a loop and half its diagonal.
std::pair<Point, double> circle_around(const Outline& loop) {
  const auto [left, right] = std::ranges::minmax(loop, {}, &Point::x);
  const auto [low, high] = std::ranges::minmax(loop, {}, &Point::y);
  const Point corner{left.x, low.y}, opposite{right.x, high.y};
  return {0.5 * (corner + opposite), distance(corner, opposite) / 2};
}

}  // namespace

std::vector<Segment> clipped(const Segment& segment, const std::vector<Outline>& loops) {
  std::vector<double> shares{0, 1};
  for (const Outline& loop : loops) add_crossings(shares, segment, loop);
  std::ranges::sort(shares);
  std::vector<Segment> pieces;
  bool goes_on = false;  // the piece before ends where this one begins
  for (std::size_t i = 1; i < shares.size(); ++i) {
    if (shares[i] - shares[i - 1] < kShortestPiece) continue;
    const Segment piece{point_at(segment, shares[i - 1]), point_at(segment, shares[i])};
    const bool is_kept = is_inside(0.5 * (piece.start + piece.end), loops);
    if (is_kept && goes_on)
      pieces.back().end = piece.end;
    else if (is_kept)
      pieces.push_back(piece);
    goes_on = is_kept;
  }
  return pieces;
}

Drawing drawing_of(const JointScene& scene) {
  const std::vector<Outline> loops = outlines_of(scene);
  Drawing drawing;
  drawing.edge_node_ratio = scene.edge_node_ratio;
  drawing.fixed_lines = scene.fixed_lines;
  drawing.measured_points = scene.measured_points;
  drawing.place = scene.place;
  for (const Outline& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      drawing.joints.push_back({side_of(loop, i), scene.boundary_material, scene.place});
  drawing.boundary_count = drawing.joints.size();
  const auto [centre, reach] = circle_around(loops.front());
  for (const JointSet& set : scene.sets)
    for (const Segment& trace : traces(set, centre, reach))
      for (const Segment& piece : clipped(trace, loops))
        drawing.joints.push_back({piece, set.joint_material, set.place});
  for (const TunnelSection& tunnel : scene.tunnels) drawing.hole_points.push_back({{tunnel.x, tunnel.y}, tunnel.place});
  return drawing;
}

}  // namespace keyblock
