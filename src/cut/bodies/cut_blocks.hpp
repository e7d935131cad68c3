// Cuts a drawing into blocks: finds crossings, merges them, prunes loose ends, traces faces and places the marks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cut/bodies/body_graph.hpp"
#include "cut/lines/arrangement.hpp"
#include "cut/lines/tolerances.hpp"
#include "problem/blocks.hpp"
#include "problem/drawing.hpp"

namespace keyblock {

/// Counts of the stages of one cutting.
struct CutReport {
  CutTolerances tolerances;
  int lines = 0;             ///< lines of non-zero length
  int crossings = 0;         ///< pairs of lines that meet (each end of an overlap counts)
  int nodes = 0;             ///< distinct points at which lines meet
  int edges = 0;             ///< pieces of lines between nodes
  int merged = 0;            ///< crossings moved to their node by more than round-off
  int placed_otherwise = 0;  ///< nodes not at the crossing that Shi's programs find first
  int reached = 0;           ///< lines prolonged by the reach to meet another
  int detours = 0;           ///< pieces led through a node beside them
  int deleted = 0;           ///< pieces that crossed or passed a node too near, if such are deleted
  int late_crossings = 0;    ///< pieces that crossed after merging and got a node
  int dangling_edges = 0;    ///< removed: one end is free
  int bridge_edges = 0;      ///< removed: the same face on both sides
  int pruned_nodes = 0;      ///< nodes left on closed chains
  int pruned_edges = 0;      ///< pieces left on closed chains
  int faces = 0;             ///< bounded faces, before slivers and holes are removed
};

struct CutResult {
  Blocks blocks;
  Warnings warnings;
  std::vector<Snap> snaps;
  CutReport report;
  /// Joint of the drawing that made the edge arriving at each corner, index from 0. Blocks follow one another, each
  /// with its outer loop before its holes.
  std::vector<int> joint_lines = {};
};

/// Returns the blocks of a drawing in the order and with the starting vertices of Shi's programs. Throws InputError if
/// the lines enclose no block.
CutResult cut_blocks(const Drawing& drawing, NodeMerging merging = NodeMerging::nearest_first,
                     NearPieces near_pieces = NearPieces::led_through);

struct BodyCut {
  CutResult blocks;
  BodyGraph graph;  ///< bodies are the blocks
};

/// Cuts the same blocks, but keeps joints that end inside them as slits; `cut_blocks` removes these. An end that passes
/// the last line by less than the merging distance is an overshoot, not a slit.
BodyCut cut_bodies(const Drawing& drawing, NodeMerging merging = NodeMerging::nearest_first,
                   NearPieces near_pieces = NearPieces::led_through);

}  // namespace keyblock
