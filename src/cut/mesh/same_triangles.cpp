// Matches nodes by their positions, then triangles by their nodes; see same_triangles.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/mesh/same_triangles.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <unordered_map>
#include <utility>

namespace keyblock {
namespace {

struct HashOfPosition {
  std::size_t operator()(const Point& p) const {
    const std::size_t x = std::hash<double>{}(p.x);  // equal for 0 and -0
    return x ^ (std::hash<double>{}(p.y) + 0x9e3779b97f4a7c15ULL + (x << 6U) + (x >> 2U));
  }
};

/// Returns, per node of `is`, the first node of `was` in the same place; -1: none.
std::vector<int> same_nodes(const std::vector<Point>& was, const std::vector<Point>& is) {
  std::unordered_map<Point, int, HashOfPosition> numbers;
  numbers.reserve(was.size());
  for (std::size_t n = 0; n < was.size(); ++n) numbers.emplace(was[n], static_cast<int>(n));
  std::vector<int> same;
  same.reserve(is.size());
  for (const Point& p : is) {
    const auto found = numbers.find(p);
    same.push_back(found == numbers.end() ? -1 : found->second);
  }
  return same;
}

}  // namespace

std::vector<int> same_triangles(const TriangleMesh& was, const TriangleMesh& is) {
  const std::vector<int> nodes = same_nodes(was.nodes, is.nodes);
  std::vector<int> first(was.nodes.size(), -1);  // first of the triangles that begin at each node
  std::vector<int> next(was.triangles.size(), -1);
  for (std::size_t t = was.triangles.size(); t-- > 0;)
    next[t] = std::exchange(first[static_cast<std::size_t>(was.triangles[t][0])], static_cast<int>(t));
  std::vector<int> same(is.triangles.size(), -1);
  for (std::size_t t = 0; t < is.triangles.size(); ++t) {
    std::array<int, 3> sought{};
    std::ranges::transform(is.triangles[t], sought.begin(), [&](int n) { return nodes[static_cast<std::size_t>(n)]; });
    if (sought[0] < 0) continue;
    int old = first[static_cast<std::size_t>(sought[0])];
    while (old >= 0 && was.triangles[static_cast<std::size_t>(old)] != sought)
      old = next[static_cast<std::size_t>(old)];
    same[t] = old;
  }
  return same;
}

bool have_same_polygon(const Manifold& was, const ManifoldElement& old, const Manifold& is,
                       const ManifoldElement& element) {
  if (old.holes.size != 0 || element.holes.size != 0) return false;
  return std::ranges::equal(was.loop(old.outer), is.loop(element.outer), {}, &ElementCorner::position,
                            &ElementCorner::position);
}

}  // namespace keyblock
