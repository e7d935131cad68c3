// Unites two blocks that share a side and removes the joint between them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "problem/blocks.hpp"

namespace keyblock {

/// Block with the joint of the drawing that made the side arriving at each corner, index from 0. Outer loop before
/// holes; `lines` is empty if the blocks were given, not cut.
struct DrawnBlock {
  BlockPolygon polygon;
  std::vector<int> lines;
};

struct UnitedBlocks {
  DrawnBlock block;
  double shared = 0;  ///< length of the shared sides
};

/// Returns the union, with the material and place of `first`, or nothing if the blocks share no side or overlap. Sides
/// that run along each other are cut at each other's corners. Corners nearer than `tolerance` [length] become the
/// corner of `first`. Gaps enclosed between the two become holes. Remaining sides keep their joint materials. A corner
/// that is left straight is removed if the material is the same on both sides of it.
std::optional<UnitedBlocks> united(const DrawnBlock& first, const DrawnBlock& second, double tolerance);

}  // namespace keyblock
