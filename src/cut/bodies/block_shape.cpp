// Computes the loops of points and the area of a block.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/bodies/block_shape.hpp"

#include "geometry/polygon.hpp"

namespace keyblock {

std::vector<std::vector<Point>> loops_of(const BlockPolygon& block) {
  std::vector<std::vector<Point>> loops{points_of(block.outer)};
  for (const BlockLoop& hole : block.holes) loops.push_back(points_of(hole));
  return loops;
}

double area_of(const BlockPolygon& block) {
  double sum = 0;
  for (const std::vector<Point>& loop : loops_of(block)) sum += area(loop);
  return sum;
}

}  // namespace keyblock
