// Declares the excavation and the cutting of blocks, which record from which block each piece came.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "cut/bodies/excavate.hpp"
#include "problem/blocks.hpp"
#include "problem/drawing.hpp"

namespace keyblock {

struct ChangedBlocks {
  Blocks blocks;
  std::vector<int> parents;  ///< per block: index of the earlier block that it is, or is a piece of
  // Earlier index of each point and bolt that is left. A point goes with the rock around it, a bolt with either end.
  std::vector<int> fixed_points;
  std::vector<int> loading_points;
  std::vector<int> measured_points;
  std::vector<int> bolts;
};

/// Excavates the regions and returns the remaining blocks in their order. Pieces of one block follow one another, the
/// largest first. Pieces thinner than half a percent of their block's size are slivers and are left out. A block of
/// which only slivers would be cut off stays whole or is removed whole.
ChangedBlocks without_regions(const Blocks& blocks, std::span<const Region> regions);

/// Cuts every block that a line crosses from side to side; a line that ends inside a block does not cut it.
ChangedBlocks cut_along(const Blocks& blocks, std::span<const JointLine> lines);

}  // namespace keyblock
