// Builds arrangements from their nodes and edges, for the tests of the later stages of cutting.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "cut/lines/arrangement.hpp"

namespace keyblock {

/// Every edge lies on a line of its own, numbered as the edge.
inline Arrangement arrangement_of(const std::vector<Point>& nodes, const std::vector<std::pair<int, int>>& edges) {
  Arrangement a;
  for (const Point& p : nodes) a.nodes.push_back({p, true});
  for (const auto& [from, to] : edges) {
    const int line = static_cast<int>(a.lines.size());
    a.edges.push_back({from, to, line, true});
    a.lines.push_back({nodes[from], nodes[to]});
  }
  return a;
}

inline std::vector<std::pair<int, int>> ends_of(const std::vector<Edge>& edges) {
  std::vector<std::pair<int, int>> ends;
  for (const Edge& e : edges) ends.push_back({e.from, e.to});
  return ends;
}

}  // namespace keyblock
