// Blocks after something is dug out of them or a line cuts them, and what each of them was before.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "problem/blocks.hpp"
#include "problem/drawing.hpp"

namespace keyblock {

/// A closed chain; what lies within it goes. The faces that this leaves have the joint material.
struct Region {
  std::vector<Point> outline;
  int joint_material = 0;  ///< index from 0
};

struct ChangedBlocks {
  Blocks blocks;
  std::vector<int> parents;  ///< of each block: the index of the block before that it is, or is a piece of
  // Of each point and bolt that is left: its index before. A point goes with the rock about it, a bolt with either end.
  std::vector<int> fixed_points;
  std::vector<int> loading_points;
  std::vector<int> measured_points;
  std::vector<int> bolts;
};

/// Blocks less all that lies within the regions, in their order; pieces of one block follow one another, the largest
/// first. Pieces thinner than half a percent of their block's size are slivers and left out; a block of which nothing
/// else is cut off goes or stays whole.
ChangedBlocks without_regions(const Blocks& blocks, std::span<const Region> regions);

/// Every block that a line passes through from side to side comes apart along it; an end inside a block cuts nothing.
ChangedBlocks cut_along(const Blocks& blocks, std::span<const JointLine> lines);

}  // namespace keyblock
