// By boxes, then by polygons; see parents.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/growth/parents.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "geometry/box_tree.hpp"
#include "geometry/polygon.hpp"
#include "geometry/segment.hpp"
#include "model/continuum.hpp"

namespace keyblock {
namespace {

std::vector<std::vector<Point>> loops_of(const Manifold& manifold, std::size_t e) {
  return manifold.polygon(manifold.elements[e]);
}

int count_on_covers(const Model& model) {
  return model.continuum ? static_cast<int>(model.continuum->manifold.elements.size()) : 0;
}

bool holds(const std::vector<std::vector<Point>>& loops, Point p) {
  bool is_inside = false;
  for (const std::vector<Point>& loop : loops) {
    const Side where = side(loop, p);
    if (where == Side::on_edge) return true;
    if (where == Side::inside) is_inside = !is_inside;
  }
  return is_inside;
}

/// For a sliver whose inner point round-off puts outside all of them.
int nearest_to(const Manifold& manifold, Point p) {
  int nearest = 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t e = 0; e < manifold.elements.size(); ++e)
    for (const std::vector<Point>& loop : loops_of(manifold, e))
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const double d = distance(Segment{loop[i], loop[(i + 1) % loop.size()]}, p);
        if (d < least) least = d, nearest = static_cast<int>(e);
      }
  return nearest;
}

}  // namespace

Table<ElementIndex, ElementIndex> parents_by_place(const Model& before, const Model& after) {
  const Manifold& was = before.continuum->manifold;
  const Manifold& is = after.continuum->manifold;
  const int blocks = static_cast<int>(after.elements.size()) - count_on_covers(after);
  std::vector<Box> boxes(was.elements.size());
  for (std::size_t e = 0; e < was.elements.size(); ++e)
    for (const ElementCorner& corner : was.loop(was.elements[e].outer)) boxes[e].add(corner.position);
  std::vector<Point> inner;
  for (std::size_t e = 0; e < is.elements.size(); ++e) {
    const auto loops = loops_of(is, e);
    const std::optional<Point> inside = point_inside(loops);
    inner.push_back(inside ? *inside : centroid(loops.front()));
    boxes.emplace_back().add(inner.back());
  }
  const int old = static_cast<int>(was.elements.size());
  std::vector<int> parent(is.elements.size(), -1);
  visit_touching(boxes, 0, [&](int i, int j) {
    if (i >= old || j < old) return true;
    int& found = parent[static_cast<std::size_t>(j - old)];
    if (found < 0 && holds(loops_of(was, static_cast<std::size_t>(i)), inner[static_cast<std::size_t>(j - old)]))
      found = i;
    return true;
  });
  Table<ElementIndex, ElementIndex> parents;
  for (int b = 0; b < blocks; ++b) parents.push_back({b});
  for (std::size_t e = 0; e < parent.size(); ++e)
    parents.push_back({blocks + (parent[e] >= 0 ? parent[e] : nearest_to(was, inner[e]))});
  return parents;
}

}  // namespace keyblock
