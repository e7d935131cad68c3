// Turns crossings into nodes and pieces of lines into edges; crossings nearer than the merging distance become one
// node.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "cut/lines/arrangement.hpp"
#include "cut/lines/crossings.hpp"
#include "cut/lines/tolerances.hpp"

namespace keyblock {

/// Node of the drawing, with the crossing that moved to it.
struct NodeMove {
  int node = 0;
  int line = 0;  ///< the higher-numbered line of the crossing that moved
  Point from;
};

struct NodeTable {
  Arrangement arrangement;
  std::vector<NodeMove> moves;  ///< crossings farther than round-off from their node
  int placed_otherwise = 0;     ///< nodes farther than round-off from the crossing found first
  /// Nodes that stayed apart from a neighbour nearer than the merging distance.
  std::vector<int> undecided_nodes;
  std::vector<int> node_of_crossing;
};

/// Makes nodes, numbered in the order of Shi's programs: crossings of boundary lines first, then by higher line, then
/// by lower line.
///
/// Under NodeMerging::nearest_first the merged crossings do not depend on that order. Pairs are joined from the nearest
/// on, while no two members of a group are farther apart than the merging distance. Two crossings of boundary lines
/// stay apart unless they coincide to round-off.
NodeTable make_nodes(std::vector<Segment> lines, std::size_t boundary_count, const Crossings& crossings,
                     const CutTolerances& tolerances, NodeMerging merging);

}  // namespace keyblock
