// Describes the motion of each body by six numbers: displacement of its centroid and displacement gradient.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "report/page/page_frame.hpp"

namespace keyblock::report {

/// Returns the centroid of the area of each body, without its holes. A body without area has the mean of its corners.
std::vector<Point> centroids_of(const PageShape& shape);

/// Displacement u of the centroid and gradient G: a corner at X from the centroid moves by u + G X.
/// In this order: ux, uy, g11, g12, g21, g22.
using AffineMotion = std::array<double, 6>;

struct BodyMotions {
  std::vector<AffineMotion> bodies;
  bool is_exact = true;  ///< no corner differs from its body's motion by more than the page rounds away
};

/// Returns the motion of each body that fits its corners best (least squares).
BodyMotions motions_of(const PageShape& shape, const std::vector<Point>& centroids, const std::vector<Point>& moves);

}  // namespace keyblock::report
