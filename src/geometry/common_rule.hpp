// Generates quadrature points for the intersection of two regions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "geometry/quadrature.hpp"

namespace keyblock {

/// Returns points and weights exact to `degree` over the intersection of two regions, or none if they have none. Each
/// region lies to the left of its closed loops (holes clockwise). It is a fan of signed triangles, and triangles clip
/// each other (Sutherland & Hodgman 1974). No decision depends on where boundaries cross, so common edges and corners
/// need no special case. Weights may be negative. Points may lie outside the intersection, but not outside the convex
/// hulls.
std::vector<AreaPoint> common_rule(std::span<const std::vector<Point>> a, std::span<const std::vector<Point>> b,
                                   int degree);

}  // namespace keyblock
