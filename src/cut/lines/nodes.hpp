// Crossings become nodes, pieces of lines between them become edges; crossings nearer than the merging
// distance are one node.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "cut/lines/arrangement.hpp"
#include "cut/lines/crossings.hpp"
#include "cut/lines/tolerances.hpp"

namespace keyblock {

/// A node of the drawing and the move its making took.
struct NodeMove {
  int node = 0;
  int line = 0;  ///< the higher-numbered line of the crossing that moved
  Point from;
};

struct NodeTable {
  Arrangement arrangement;
  std::vector<NodeMove> moves;  ///< crossings farther than round-off from their node
  int placed_otherwise = 0;     ///< nodes farther than round-off from the crossing found first
  /// Nodes with a neighbour nearer than the merging distance that stayed apart.
  std::vector<int> undecided_nodes;
  std::vector<int> node_of_crossing;
};

/// Numbers the nodes in the order in which the old programs find them: boundary lines' crossings first, then
/// by higher line, then by lower line.
///
/// Under NodeMerging::nearest_first, which crossings merge does not depend on that order: pairs are joined from the
/// nearest on, as long as no two members of a group are farther apart than the merging distance. Two crossings of
/// boundary lines stay apart unless they coincide to round-off.
NodeTable make_nodes(std::vector<Segment> lines, std::size_t boundary_count, const Crossings& crossings,
                     const CutTolerances& tolerances, NodeMerging merging);

}  // namespace keyblock
