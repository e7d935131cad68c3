// Two blocks that share a side become one; the joint between them goes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "problem/blocks.hpp"

namespace keyblock {

/// A block, and of the side that arrives at each corner (outer loop before holes) the joint of the drawing that made
/// it, index from 0; no lines where blocks were given.
struct DrawnBlock {
  BlockPolygon polygon;
  std::vector<int> lines;
};

struct UnitedBlocks {
  DrawnBlock block;
  double shared = 0;  ///< length of the sides that they had in common
};

/// Their union, of the material and place of the first, or nothing where they share no side or lie on one another.
/// Sides that run along each other are cut at each other's corners; corners nearer than `tolerance` (length) are one,
/// that of the first. What is enclosed between the two becomes a hole. Remaining sides keep their joint materials; a
/// corner that is left straight goes where the material is the same on both sides of it.
std::optional<UnitedBlocks> united(const DrawnBlock& first, const DrawnBlock& second, double tolerance);

}  // namespace keyblock
