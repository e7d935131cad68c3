// Declares the loops of points of a block, and its area.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "problem/blocks.hpp"

namespace keyblock {

/// Returns the corners of the outer loop, then those of each hole.
std::vector<std::vector<Point>> loops_of(const BlockPolygon& block);

/// Returns the area of the block without its holes.
double area_of(const BlockPolygon& block);

}  // namespace keyblock
