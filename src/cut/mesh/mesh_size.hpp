// How long the sides of a mesh may be in a place.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "geometry/point.hpp"
#include "problem/cover_plan.hpp"

namespace keyblock {

/// The longest side wanted in a place: `side`, or less near refined points, from which it grows by `growth` per length.
/// Lengths in the unit of the drawing, `side` and those of refined points above 0. A copy shares the points.
class MeshSize {
 public:
  MeshSize(double side, std::vector<RefinedPoint> refined, double growth);

  double side() const { return side_; }
  const std::vector<RefinedPoint>& refined() const { return *refined_; }
  double growth() const { return growth_; }
  /// Of `side` and those of the points.
  double least() const { return least_; }

  /// Of many points few are looked at.
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
