// Where pairs of lines meet: every crossing once, and along each line the crossings in exact order.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "cut/lines/tolerances.hpp"
#include "geometry/predicates.hpp"

namespace keyblock {

/// Two lines meet. `position` is evaluated on the higher-numbered line, as the old programs do (last bits
/// matter there). Along each other lines meet where an end of one lies on the other: `is_end`, and `position`
/// is that end.
struct Crossing {
  int line = 0;   ///< the higher-numbered one
  int other = 0;  ///< the lower-numbered one
  Point position;
  bool is_end = false;
  bool is_reached = false;  ///< the lines miss each other by less than the reach and are taken to meet
};

/// A crossing as it stands on one line.
struct Stop {
  Station station;
  int crossing = 0;
};

struct Crossings {
  std::vector<Crossing> found;            ///< by higher line, then lower line
  std::vector<std::size_t> first_stop;    ///< of each line, and one past the last
  std::vector<Stop> stops;                ///< of each line in order along it
  std::vector<std::size_t> equal_before;  ///< stops standing exactly where the stop before them stands
};

Crossings find_crossings(std::span<const Segment> lines, const CutTolerances& tolerances);

}  // namespace keyblock
