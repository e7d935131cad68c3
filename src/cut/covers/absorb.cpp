// Absorbs small pieces; see absorb.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/covers/absorb.hpp"

#include <algorithm>
#include <vector>

#include "cut/covers/physical_covers.hpp"
#include "geometry/polygon.hpp"

namespace keyblock {
namespace {

constexpr double kSmallOverMean = 0.2;

double area_of(const Manifold& manifold, const ManifoldElement& element) {
  double sum = 0;
  for (const std::vector<Point>& loop : manifold.polygon(element)) sum += area(loop);
  return sum;
}

bool is_alone_on_a_cover(const Manifold& manifold, const ManifoldElement& element) {
  return std::any_of(element.covers.begin(), element.covers.end(),
                     [&](int cover) { return manifold.covers[cover].elements.size == 1; });
}

/// Returns the neighbour across the longest edge, or -1. A piece alone on a cover has neighbours across one side only.
int nearest_neighbour(const Manifold& manifold, const ManifoldElement& element) {
  int best = -1;
  double longest = 0;
  const auto look = [&](const SlotRange& range) {
    const auto loop = manifold.loop(range);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const double edge = distance(loop[i].position, loop[i + 1 == loop.size() ? 0 : i + 1].position);
      if (loop[i].neighbour < 0 || edge <= longest) continue;
      longest = edge;
      best = loop[i].neighbour;
    }
  };
  look(element.outer);
  for (const SlotRange& hole : manifold.holes_of(element)) look(hole);
  return best;
}

}  // namespace

int absorb_small_pieces(Manifold& manifold) {
  std::vector<double> areas;
  double sum = 0;
  for (const ManifoldElement& element : manifold.elements) {
    areas.push_back(area_of(manifold, element));
    sum += areas.back();
  }
  const double limit = kSmallOverMean * sum / static_cast<double>(areas.size());
  int count = 0;
  for (std::size_t e = 0; e < areas.size(); ++e) {
    ManifoldElement& element = manifold.elements[e];
    if (areas[e] >= limit || !is_alone_on_a_cover(manifold, element)) continue;
    const int neighbour = nearest_neighbour(manifold, element);
    if (neighbour < 0) continue;
    element.triangle = manifold.elements[neighbour].triangle;
    element.covers = manifold.elements[neighbour].covers;
    ++count;
  }
  relist_covers(manifold);
  return count;
}

}  // namespace keyblock
