// Computes the area of the intersection of two bodies.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace keyblock {

/// Closed chains: the outer ones counter-clockwise, holes clockwise.
using Loops = std::vector<std::vector<Point>>;

/// Returns the area within both, ≥ 0 up to a few ulps of the areas of the bodies. It is 0 if an edge of the outer loop
/// of one body has all of the other beyond it. The time grows as the product of the numbers of corners.
double common_area(const Loops& a, const Loops& b);

}  // namespace keyblock
