// Integrals over what two regions have in common.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "geometry/quadrature.hpp"

namespace keyblock {

/// Points and weights exact to `degree` over the common part of two regions, each to the left of its closed loops
/// (holes clockwise); none where they have none. Each region is a fan of triangles with signs, and a triangle is
/// clipped by another (Sutherland & Hodgman 1974): nothing has to be decided about where boundaries cross, so that
/// common edges and corners are nothing special. Weights may be negative, and points may lie outside the common part,
/// but not outside the convex hulls.
std::vector<AreaPoint> common_rule(std::span<const std::vector<Point>> a, std::span<const std::vector<Point>> b,
                                   int degree);

}  // namespace keyblock
