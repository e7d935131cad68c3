// Holds loads and supports on edges of DDA blocks, as forces and rows at material points.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "base/index.hpp"
#include "geometry/point.hpp"
#include "problem/time_curve.hpp"

namespace keyblock {

/// Forces of a traction on the ends of an edge. With the shape functions 1 - s and s of the ends, s from 0 to 1 along
/// the edge,
///     F_a = ∫ (1 - s) t dL,   F_b = ∫ s t dL.
/// Along an edge the motion of a block is linear, so that these forces do the work of the traction.
struct EdgeForces {
  std::array<Point, 2> forces = {};   ///< at start and end, of the traction with a fixed direction
  std::array<double, 2> pushes = {};  ///< ∫ (1 - s) p ds and ∫ s p ds of a pressure: times normal times length now
  double factor = 1;                  ///< of all
};

/// Traction on an edge of a block.
struct EdgeLoad {
  ElementIndex element;
  Segment edge;                               ///< undeformed; the block lies to its left
  std::function<EdgeForces(double time)> at;  ///< throws InputError if a formula is not finite
  double last_change = 0;                     ///< time from which it stays the same; 0: it never changes
  std::vector<double> bends = {};             ///< times of the rows of its table
};

/// Support of one component of the motion of a point of a block.
struct SupportRow {
  ElementIndex element;
  Point start;       ///< undeformed
  Point direction;   ///< of length 1
  double value = 0;  ///< prescribed displacement along it
  TimeCurve factor;  ///< of the value; its x counts; empty: 1
};

}  // namespace keyblock
