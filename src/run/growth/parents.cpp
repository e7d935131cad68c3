// Finds parents by triangles that both meshes have, otherwise by boxes and then polygons; see parents.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/growth/parents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "cut/mesh/same_triangles.hpp"
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

/// Serves slivers whose inner point lies outside all elements by round-off.
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

// The middle of a piece often lies on a side of the mesh before, where rounding would choose the parent. A point that
// is off the middle by no simple fraction does not.
constexpr double kOffMiddle = 0.1387;

Point inner_point(const Manifold& manifold, std::size_t e) {
  const auto loops = loops_of(manifold, e);
  const std::optional<Point> inside = point_inside(loops);
  const Point middle = inside ? *inside : centroid(loops.front());
  const Point off = middle + kOffMiddle * (loops.front().front() - middle);
  return holds(loops, off) ? off : middle;
}

void describe_names(Archive& archive, std::vector<Identity>& names) {
  archive.list("names", names, [&](Identity& name) {
    archive.value("number", name.number);
    archive.value("origin", name.origin);
  });
}

/// Returns the parents of elements in unchanged triangles; -1 for the others.
std::vector<int> parents_in_triangles(const Manifold& was, const Manifold& is) {
  std::vector<int> parent(is.elements.size(), -1);
  const std::vector<int> triangles = same_triangles(was.mesh, is.mesh);
  std::vector<int> first(was.mesh.triangles.size(), -1);  // of the elements of each triangle
  std::vector<int> next(was.elements.size(), -1);
  for (std::size_t e = was.elements.size(); e-- > 0;) {
    int& head = first[static_cast<std::size_t>(was.elements[e].triangle)];
    next[e] = std::exchange(head, static_cast<int>(e));
  }
  for (std::size_t e = 0; e < is.elements.size(); ++e) {
    const ManifoldElement& element = is.elements[e];
    const int triangle = triangles[static_cast<std::size_t>(element.triangle)];
    if (triangle < 0) continue;
    const int head = first[static_cast<std::size_t>(triangle)];
    for (int old = head; old >= 0 && parent[e] < 0; old = next[static_cast<std::size_t>(old)])
      if (have_same_polygon(was, was.elements[static_cast<std::size_t>(old)], is, element)) parent[e] = old;
    if (head < 0 || parent[e] >= 0) continue;
    const Point inner = inner_point(is, e);
    for (int old = head; old >= 0 && parent[e] < 0; old = next[static_cast<std::size_t>(old)])
      if (holds(loops_of(was, static_cast<std::size_t>(old)), inner)) parent[e] = old;
  }
  return parent;
}

/// Fills the negative entries of `parent`.
void find_by_boxes(const Manifold& was, const Manifold& is, std::vector<int>& parent) {
  std::vector<Box> boxes(was.elements.size());
  for (std::size_t e = 0; e < was.elements.size(); ++e)
    for (const ElementCorner& corner : was.loop(was.elements[e].outer)) boxes[e].add(corner.position);
  std::vector<std::size_t> sought;
  std::vector<Point> inner;
  for (std::size_t e = 0; e < parent.size(); ++e) {
    if (parent[e] >= 0) continue;
    sought.push_back(e);
    inner.push_back(inner_point(is, e));
    boxes.emplace_back().add(inner.back());
  }
  const int old = static_cast<int>(was.elements.size());
  visit_touching(boxes, 0, [&](int i, int j) {
    if (i >= old || j < old) return true;
    const auto k = static_cast<std::size_t>(j - old);
    int& found = parent[sought[k]];
    if (found < 0 && holds(loops_of(was, static_cast<std::size_t>(i)), inner[k])) found = i;
    return true;
  });
  for (std::size_t k = 0; k < sought.size(); ++k)
    if (parent[sought[k]] < 0) parent[sought[k]] = nearest_to(was, inner[k]);
}

}  // namespace

Table<ElementIndex, ElementIndex> parents_by_place(const Model& before, const Model& after) {
  const Manifold& was = before.continuum->manifold;
  const Manifold& is = after.continuum->manifold;
  const int blocks = static_cast<int>(after.elements.size()) - count_on_covers(after);
  std::vector<int> parent = parents_in_triangles(was, is);
  if (std::ranges::any_of(parent, [](int p) { return p < 0; })) find_by_boxes(was, is, parent);
  Table<ElementIndex, ElementIndex> parents;
  for (int b = 0; b < blocks; ++b) parents.push_back({b});
  for (const int p : parent) parents.push_back({blocks + p});
  return parents;
}

void save_names(Archive& archive, const Model& model) {
  std::vector<Identity> names = model.identities.elements;
  describe_names(archive, names);
}

void restore_names(Archive& saved, Model& model) {
  std::vector<Identity>& names = model.identities.elements;
  describe_names(saved, names);
  if (!names.empty() && names.size() != model.elements.size())
    saved.refuse("names",
                 fmt::format("expected the names of {} elements, found {}", model.elements.size(), names.size()));
}

}  // namespace keyblock
