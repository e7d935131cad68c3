// Finds where pairs of lines meet: every crossing once, and the crossings along each line in exact order.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "cut/lines/tolerances.hpp"
#include "geometry/predicates.hpp"

namespace keyblock {

/// Meeting of two lines. `position` is evaluated on the higher-numbered line, as in Shi's programs, because the last
/// bits matter there. Lines along each other meet where an end of one lies on the other; `is_end` is then true and
/// `position` is that end.
struct Crossing {
  int line = 0;   ///< the higher-numbered line
  int other = 0;  ///< the lower-numbered line
  Point position;
  bool is_end = false;
  bool is_reached = false;  ///< the lines miss each other by less than the reach and are taken to meet
};

/// Crossing at its place on one line.
struct Stop {
  Station station;
  int crossing = 0;
};

struct Crossings {
  std::vector<Crossing> found;            ///< by higher line, then lower line
  std::vector<std::size_t> first_stop;    ///< per line, and one past the last
  std::vector<Stop> stops;                ///< per line, in order along it
  std::vector<std::size_t> equal_before;  ///< stops exactly at the place of the stop before them
};

Crossings find_crossings(std::span<const Segment> lines, const CutTolerances& tolerances);

}  // namespace keyblock
