// Cuts a drawing into blocks: crossings, merging, pruning, faces, then the marks into their blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cut/bodies/body_graph.hpp"
#include "cut/lines/arrangement.hpp"
#include "cut/lines/tolerances.hpp"
#include "problem/blocks.hpp"
#include "problem/drawing.hpp"

namespace keyblock {

/// What cutting met on its way.
struct CutReport {
  CutTolerances tolerances;
  int lines = 0;             ///< lines with a length
  int crossings = 0;         ///< pairs of lines that meet (ends of overlaps singly)
  int nodes = 0;             ///< distinct points where lines meet
  int edges = 0;             ///< pieces of lines between nodes
  int merged = 0;            ///< crossings moved to their node by more than round-off
  int placed_otherwise = 0;  ///< nodes not at the crossing that the old programs would have found first
  int reached = 0;           ///< lines prolonged by the reach to meet another
  int detours = 0;           ///< pieces led through a node beside them
  int deleted = 0;           ///< pieces that passed a node too near, or crossed, where such are deleted
  int late_crossings = 0;    ///< pieces that crossed after merging and got a node
  int dangling_edges = 0;    ///< removed: they hang loose
  int bridge_edges = 0;      ///< removed: the same face on both sides
  int pruned_nodes = 0;      ///< nodes left on closed chains
  int pruned_edges = 0;      ///< pieces left on closed chains
  int faces = 0;             ///< bounded faces, before slivers and holes go
};

struct CutResult {
  Blocks blocks;
  Warnings warnings;
  std::vector<Snap> snaps;
  CutReport report;
  /// Of the edge that arrives at each corner, of block after block, outer loop before holes: the joint of the drawing
  /// that made it, index from 0.
  std::vector<int> joint_lines = {};
};

/// The blocks of a drawing in the order and with the starting vertices of the old programs. Throws InputError
/// where the lines close no block.
CutResult cut_blocks(const Drawing& drawing, NodeMerging merging = NodeMerging::nearest_first,
                     NearPieces near_pieces = NearPieces::led_through);

struct BodyCut {
  CutResult blocks;
  BodyGraph graph;  ///< its bodies are the blocks
};

/// The same blocks with the joints that end inside them, which `cut_blocks` removes: slits. An end that passes the last
/// line by less than the merging distance is an overshoot, not a slit.
BodyCut cut_bodies(const Drawing& drawing, NodeMerging merging = NodeMerging::nearest_first,
                   NearPieces near_pieces = NearPieces::led_through);

}  // namespace keyblock
