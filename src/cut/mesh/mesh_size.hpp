// Computes the longest side allowed at each place of a mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "geometry/point.hpp"
#include "problem/cover_plan.hpp"

namespace keyblock {

/// Longest side allowed at a place: `side`, or less near refined points, from which it grows by `growth` per length.
/// Lengths in the unit of the drawing; `side` and the sides of refined points are above 0. Copies share the points.
class MeshSize {
 public:
  MeshSize(double side, std::vector<RefinedPoint> refined, double growth);

  double side() const { return side_; }
  const std::vector<RefinedPoint>& refined() const { return *refined_; }
  double growth() const { return growth_; }
  /// Returns the least of `side` and the sides of the points.
  double least() const { return least_; }

  /// Returns the longest side at p; visits few of many points.
  double at(Point p) const;

 private:
  class Halves;

  double side_ = 1;
  double growth_ = 0.3;
  double least_ = 1;
  std::shared_ptr<const std::vector<RefinedPoint>> refined_;
  std::shared_ptr<const Halves> halves_;
};

}  // namespace keyblock
