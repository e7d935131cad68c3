// How much of the plane two bodies have in common.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace keyblock {

/// Closed chains: the outer ones counter-clockwise, holes clockwise.
using Loops = std::vector<std::vector<Point>>;

/// The area within both, ≥ 0 but for a few ulps of the areas of the bodies; 0 where an edge of the outer loop of one
/// has all of the other beyond it. It takes time as the product of their numbers of corners.
double common_area(const Loops& a, const Loops& b);

}  // namespace keyblock
