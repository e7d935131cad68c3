// Holds the result of cutting a drawing: blocks, warnings, snaps and counts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cut/lines/arrangement.hpp"
#include "cut/lines/tolerances.hpp"
#include "problem/blocks.hpp"

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

}  // namespace keyblock
