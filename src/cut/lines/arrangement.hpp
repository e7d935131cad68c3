// Holds the nodes and edges that lines form in the plane, which the stages of cutting pass on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/error.hpp"
#include "geometry/point.hpp"

namespace keyblock {

/// Point where lines meet. `is_exact`: all its crossings are the same point of the plane; no crossing was merged.
struct Node {
  Point position;
  bool is_exact = true;
};

/// Piece between two nodes, in the direction of its line. `is_on_line`: it lies exactly on its line. The direction of
/// the line then decides its order around a node, free of the rounding of node coordinates.
struct Edge {
  int from = 0;
  int to = 0;
  int line = 0;
  bool is_on_line = true;
};

/// A point moved by more than round-off to make the pieces of the drawing meet.
struct Snap {
  enum class Kind { node_merged, end_reached, edge_rerouted };
  Kind kind = Kind::node_merged;
  Point from;
  Point to;
  Place place;  ///< the line that was moved
};

constexpr const char* to_string(Snap::Kind kind) {
  switch (kind) {
    case Snap::Kind::node_merged:
      return "node_merged";
    case Snap::Kind::end_reached:
      return "end_reached";
    case Snap::Kind::edge_rerouted:
      return "edge_rerouted";
  }
  return "";
}

struct Arrangement {
  std::vector<Segment> lines;  ///< indexed by `Edge::line`
  std::vector<Node> nodes;
  std::vector<Edge> edges;
};

}  // namespace keyblock
