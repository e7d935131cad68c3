// Nodes and edges that lines make of the plane: what the stages of cutting hand to each other.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/error.hpp"
#include "geometry/point.hpp"

namespace keyblock {

/// Where lines meet. `is_exact`: all its crossings are one and the same point of the plane; nothing was
/// merged.
struct Node {
  Point position;
  bool is_exact = true;
};

/// A piece between two nodes, in the direction of its line. `is_on_line`: it lies exactly on its line, whose
/// direction then rules its order about a node, free of the rounding of node coordinates.
struct Edge {
  int from = 0;
  int to = 0;
  int line = 0;
  bool is_on_line = true;
};

/// Something moved by more than round-off to make the drawing's pieces meet.
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
  std::vector<Segment> lines;  ///< what `Edge::line` counts
  std::vector<Node> nodes;
  std::vector<Edge> edges;
};

}  // namespace keyblock
