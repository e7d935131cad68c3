// By boxes, then by polygons; see parents.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/growth/parents.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "geometry/box_tree.hpp"
#include "geometry/polygon.hpp"
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
  for (const int p : parent) {
    if (p < 0) throw std::logic_error("an element of a body that was cut anew lies outside what it was before");
    parents.push_back({blocks + p});
  }
  return parents;
}

}  // namespace keyblock
