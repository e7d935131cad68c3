// Puts the marks of a drawing into blocks: fixed lines and points, loading and measured points, bolts,
// hole points and material lines.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "cut/lines/tolerances.hpp"
#include "problem/blocks.hpp"
#include "problem/drawing.hpp"

namespace keyblock {

/// Does the block hold the point? Its edges belong to it, holes do not.
bool holds(const BlockPolygon& block, Point p);

/// The first block with a vertex within `vertex_catch` of the point, else the first one holding it.
std::optional<int> block_at(const std::vector<BlockPolygon>& blocks, Point p, double vertex_catch);

/// The block nearest to a point outside all of them, and its point nearest to that; nothing farther than `reach`.
struct BlockBeside {
  int block = 0;
  Point nearest;
};
std::optional<BlockBeside> block_beside(const std::vector<BlockPolygon>& blocks, Point p, double reach);

struct PlacedMarks {
  std::vector<int> kept;  ///< of each block left after the holes, its number before
  Warnings warnings;
};

/// Removes the blocks that hold hole points, sets materials, and adds every carried point and bolt to
/// `blocks`. Points outside all blocks, but within the merging distance of one, are moved onto it (`points_moved` where
/// that is more than round-off). What lies farther outside is left out with the warning `point_outside_blocks`.
PlacedMarks place_marks(const Drawing& drawing, const CutTolerances& tolerances, Blocks& blocks);

}  // namespace keyblock
