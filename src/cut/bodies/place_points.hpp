// Places the marks of a drawing in blocks: fixed lines and points, loading and measured points, bolts, hole points and
// material lines.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "cut/lines/tolerances.hpp"
#include "problem/blocks.hpp"
#include "problem/drawing.hpp"

namespace keyblock {

/// Returns true if the block holds the point. Edges belong to the block, holes do not.
bool holds(const BlockPolygon& block, Point p);

/// Returns the first block with a vertex within `vertex_catch` of the point, or else the first one that holds it.
std::optional<int> block_at(const std::vector<BlockPolygon>& blocks, Point p, double vertex_catch);

/// The nearest block to a point outside all blocks, and the nearest point on it.
struct BlockBeside {
  int block = 0;
  Point nearest;
};
std::optional<BlockBeside> block_beside(const std::vector<BlockPolygon>& blocks, Point p, double reach);

struct PlacedMarks {
  std::vector<int> kept;  ///< per block left after the holes: its earlier number
  Warnings warnings;
};

/// Removes the blocks that hold hole points, sets materials, and adds every point and bolt to `blocks`. A point outside
/// all blocks, but within the merging distance of one, is moved onto it; `points_moved` warns of moves above round-off.
/// Points farther outside are left out with the warning `point_outside_blocks`.
PlacedMarks place_marks(const Drawing& drawing, const CutTolerances& tolerances, Blocks& blocks);

}  // namespace keyblock
