// A block as plain loops of points.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "problem/blocks.hpp"

namespace keyblock {

/// Where its corners lie: the outer loop, then its holes.
std::vector<std::vector<Point>> loops_of(const BlockPolygon& block);

/// Less its holes.
double area_of(const BlockPolygon& block);

}  // namespace keyblock
