// Holds the path of one measured point in the form of the Berkeley program.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/point.hpp"

namespace keyblock {

/// Row: the end of a step.
struct MeasuredRow {
  int step = 0;
  double time = 0;
  double time_step = 0;
  Point position;
  double displacement = 0;  ///< since the start
  Point velocity;
  double speed = 0;

  bool operator==(const MeasuredRow&) const = default;
};

struct MeasuredTrack {
  int point = 0;  ///< index from 0
  std::vector<MeasuredRow> rows;

  bool operator==(const MeasuredTrack&) const = default;
};

}  // namespace keyblock
