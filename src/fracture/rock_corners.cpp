// Finds one root, and the angles of boundary loops; see rock_corners.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/rock_corners.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

constexpr int kHalvings = 50;         // bisections of a range of 1/2
constexpr double kLeastOrder = 1e-3;  // at a tenth of a degree: the rounding of straight lines

}  // namespace

double stress_order(double angle) {
  if (!(angle > std::numbers::pi)) return 0;
  const double sine = std::sin(angle);
  // One sign change between 1/2, where it is sin ω/2 (1 + cos ω/2) >= 0, and 1, where it is 2 sin ω <= 0.
  double low = 0.5, high = 1;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (std::sin(middle * angle) + middle * sine > 0 ? low : high) = middle;
  }
  return 1 - low;
}

std::vector<RockCorner> rock_corners(const Manifold& manifold) {
  std::vector<RockCorner> corners;
  const auto edge = [&](const SlotRange& loop, int k) {
    return manifold.boundary_edges[static_cast<std::size_t>(loop.first + k % loop.size)];
  };
  const auto place = [&](const BoundaryEdge& e) {
    return manifold.corners[static_cast<std::size_t>(e.corner)].position;
  };
  for (const SlotRange& loop : manifold.boundary_loops)
    for (int k = 0; k < loop.size; ++k) {
      const Point at = place(edge(loop, k + 1));
      const Point in = at - place(edge(loop, k)), out = place(edge(loop, k + 2)) - at;
      const double order = stress_order(std::numbers::pi - std::atan2(cross(in, out), dot(in, out)));
      if (order < kLeastOrder || std::ranges::count(manifold.tips, at, &CrackTip::at) > 0) continue;
      corners.push_back({at, edge(loop, k + 1).element, order});
    }
  return corners;
}

}  // namespace keyblock
