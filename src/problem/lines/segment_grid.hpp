// Finds segments that may come near a given one, by a uniform grid.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace keyblock {

/// Enters each segment in every cell that it, widened by `margin`, touches.
class SegmentGrid {
 public:
  SegmentGrid(std::span<const Segment> segments, double margin);

  /// Returns indices below `limit`, ascending and each once, of the segments sharing a cell with `segment`. Valid until
  /// the next call.
  const std::vector<int>& near(const Segment& segment, int limit);

 private:
  template <class Visit>
  void visit_cells(const Segment& segment, Visit visit) const;
  int column(double x) const;
  int row(double y) const;

  Point low_;
  double cell_ = 1;
  double margin_ = 0;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::size_t> start_;  // per cell: begin of its part of entries_
  std::vector<int> entries_;
  std::vector<int> seen_;  // number of the last call that met the segment
  int call_ = 0;
  std::vector<int> found_;
};

}  // namespace keyblock
