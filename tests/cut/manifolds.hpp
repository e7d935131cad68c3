// Checks the properties of every cut mesh: areas, triangles, stars, neighbours, and Euler's count.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "base/union_find.hpp"
#include "geometry/box.hpp"
#include "geometry/polygon.hpp"
#include "problem/manifold.hpp"

namespace keyblock {

inline double area(const Manifold& manifold, const ManifoldElement& element) {
  double sum = 0;
  for (const std::vector<Point>& loop : manifold.polygon(element)) sum += area(loop);
  return sum;
}

inline std::vector<double> areas_of_bodies(const Manifold& manifold) {
  std::vector<double> sums(manifold.body_materials.size(), 0);
  for (const ManifoldElement& element : manifold.elements)
    sums[static_cast<std::size_t>(element.body)] += area(manifold, element);
  return sums;
}

inline double area_within_loops(const Manifold& manifold) {
  double sum = 0;
  for (const SlotRange& loop : manifold.boundary_loops) {
    std::vector<Point> points;
    for (int k = loop.first; k < loop.first + loop.size; ++k) {
      const BoundaryEdge& edge = manifold.boundary_edges[static_cast<std::size_t>(k)];
      points.push_back(manifold.corners[static_cast<std::size_t>(edge.corner)].position);
    }
    sum += area(points);
  }
  return sum;
}

/// An element's edge: the corner it leaves, the corner it reaches.
struct ElementEdge {
  int element = 0;
  int from = 0;
  int to = 0;
};

inline std::vector<ElementEdge> edges_of(const Manifold& manifold) {
  std::vector<ElementEdge> edges;
  const auto add = [&](int element, const SlotRange& loop) {
    for (int i = 0; i < loop.size; ++i)
      edges.push_back({element, loop.first + i, loop.first + (i + 1 == loop.size ? 0 : i + 1)});
  };
  for (int e = 0; e < static_cast<int>(manifold.elements.size()); ++e) {
    const ManifoldElement& element = manifold.elements[static_cast<std::size_t>(e)];
    add(e, element.outer);
    for (const SlotRange& hole : manifold.holes_of(element)) add(e, hole);
  }
  return edges;
}

/// Checks that edges with a neighbour come in pairs: each has its reverse, to the bit, in that neighbour.
inline std::vector<std::array<ElementEdge, 2>> inner_edges_of(const Manifold& manifold) {
  using Key = std::array<double, 4>;
  const auto at = [&](int corner) { return manifold.corners[static_cast<std::size_t>(corner)].position; };
  std::map<std::pair<std::array<int, 2>, Key>, ElementEdge> waiting;
  std::vector<std::array<ElementEdge, 2>> pairs;
  for (const ElementEdge& edge : edges_of(manifold)) {
    const int beyond = manifold.corners[static_cast<std::size_t>(edge.from)].neighbour;
    if (beyond < 0) continue;
    const Point p = at(edge.from);
    const Point q = at(edge.to);
    const auto found = waiting.find({{beyond, edge.element}, {q.x, q.y, p.x, p.y}});
    if (found == waiting.end()) {
      waiting[{{edge.element, beyond}, {p.x, p.y, q.x, q.y}}] = edge;
    } else {
      pairs.push_back({found->second, edge});
      waiting.erase(found);
    }
  }
  EXPECT_TRUE(waiting.empty()) << waiting.size() << " edges lead to a neighbour that does not lead back";
  return pairs;
}

/// Checks V - E + F of all elements joined along inner edges. In every connected piece of the plane it is 2 less the
/// number of boundary loops.
inline void expect_euler(const Manifold& manifold) {
  UnionFind vertices(manifold.corners.size());
  UnionFind pieces(manifold.elements.size());
  const auto inner = inner_edges_of(manifold);
  for (const auto& [a, b] : inner) {
    vertices.unite(a.from, b.to);
    vertices.unite(a.to, b.from);
    pieces.unite(a.element, b.element);
  }
  const auto count_groups = [](UnionFind& groups, std::size_t size) {
    int count = 0;
    for (int i = 0; i < static_cast<int>(size); ++i) count += groups.find(i) == i ? 1 : 0;
    return count;
  };
  const int vertex_count = count_groups(vertices, manifold.corners.size());
  const int edge_count = static_cast<int>(edges_of(manifold).size() - inner.size());
  const int face_count = static_cast<int>(manifold.elements.size()) - static_cast<int>(manifold.holes.size());
  const int piece_count = count_groups(pieces, manifold.elements.size());
  EXPECT_EQ(vertex_count - edge_count + face_count, 2 * piece_count - static_cast<int>(manifold.boundary_loops.size()));
}

/// Checks that every corner lies in its triangle up to round-off, and that the covers of an element are distinct and
/// belong to the nodes of its triangle.
inline void expect_elements_in_triangles(const Manifold& manifold) {
  for (const ManifoldElement& element : manifold.elements) {
    const std::array<Point, 3> t = manifold.triangle(element);
    for (std::size_t k = 0; k < 3; ++k) {
      const Point side = t[(k + 1) % 3] - t[k];
      const double round_off = 1e-12 * (length(side) + length(t[k]));
      for (const std::vector<Point>& loop : manifold.polygon(element))
        for (const Point p : loop) EXPECT_GE(cross(side, p - t[k]) / length(side), -round_off);
      const PhysicalCover& cover = manifold.covers[static_cast<std::size_t>(element.covers[k])];
      EXPECT_EQ(cover.node, manifold.mesh.triangles[static_cast<std::size_t>(element.triangle)][k]);
    }
    EXPECT_NE(element.covers[0], element.covers[1]);
    EXPECT_NE(element.covers[1], element.covers[2]);
    EXPECT_NE(element.covers[2], element.covers[0]);
  }
}

/// Checks that neighbours share the covers of their common side, and that the elements of a cover are connected through
/// such neighbours.
inline void expect_covers_connected(const Manifold& manifold) {
  const auto has = [&](int e, int cover) {
    const auto& covers = manifold.elements[static_cast<std::size_t>(e)].covers;
    return std::find(covers.begin(), covers.end(), cover) != covers.end();
  };
  std::map<std::array<int, 2>, int> place;  // of (cover, element)
  for (int c = 0; c < static_cast<int>(manifold.covers.size()); ++c) {
    for (const int e : manifold.elements_of(manifold.covers[static_cast<std::size_t>(c)])) {
      EXPECT_TRUE(has(e, c));
      EXPECT_TRUE(place.emplace(std::array{c, e}, static_cast<int>(place.size())).second);
    }
  }
  EXPECT_EQ(place.size(), 3 * manifold.elements.size());
  UnionFind groups(place.size());
  for (const auto& [a, b] : inner_edges_of(manifold)) {
    int shared = 0;
    for (const int c : manifold.elements[static_cast<std::size_t>(a.element)].covers) {
      if (!has(b.element, c)) continue;
      ++shared;
      groups.unite(place[{c, a.element}], place[{c, b.element}]);
    }
    EXPECT_EQ(shared, 2);
  }
  std::set<int> leaders;
  for (int i = 0; i < static_cast<int>(place.size()); ++i) leaders.insert(groups.find(i));
  EXPECT_EQ(leaders.size(), manifold.covers.size());
}

/// Checks that each edge ends at the beginning of the next one of its loop, and that every edge without a neighbour is
/// in one loop.
inline void expect_loops_closed(const Manifold& manifold) {
  std::map<int, int> head;  // of the edge that leaves a corner
  std::size_t boundary = 0;
  for (const ElementEdge& edge : edges_of(manifold)) {
    head[edge.from] = edge.to;
    const ElementCorner& corner = manifold.corners[static_cast<std::size_t>(edge.from)];
    boundary += corner.neighbour < 0 ? 1 : 0;
    EXPECT_EQ(corner.joint_material < 0, corner.neighbour >= 0);
  }
  EXPECT_EQ(manifold.boundary_edges.size(), boundary);
  std::set<int> seen;
  for (const SlotRange& loop : manifold.boundary_loops) {
    for (int i = 0; i < loop.size; ++i) {
      const auto& here = manifold.boundary_edges[static_cast<std::size_t>(loop.first + i)];
      const auto& next = manifold.boundary_edges[static_cast<std::size_t>(loop.first + (i + 1) % loop.size)];
      EXPECT_TRUE(seen.insert(here.corner).second);
      EXPECT_LT(manifold.corners[static_cast<std::size_t>(here.corner)].neighbour, 0);
      EXPECT_EQ(manifold.corners[static_cast<std::size_t>(head[here.corner])].position,
                manifold.corners[static_cast<std::size_t>(next.corner)].position);
    }
  }
}

inline void expect_sound(const Manifold& manifold) {
  expect_elements_in_triangles(manifold);
  expect_covers_connected(manifold);
  expect_loops_closed(manifold);
  expect_euler(manifold);
}

}  // namespace keyblock
