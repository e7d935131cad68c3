// Bodies that lie in one another.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/common_area.hpp"

namespace keyblock {

inline constexpr int kMostSharedPairs = 1000;  ///< counted: enough to be told

struct SharedArea {
  int first = 0;  ///< the first pair by their numbers
  int second = 0;
  double share = 0;         ///< the area that pair has in common over that of the smaller of the two
  int pairs = 0;            ///< how many there are; none: 0, and so is all else
  bool is_complete = true;  ///< false: corners crowd, and not every pair was looked at
};

/// Pairs of bodies that have more than `least` of the smaller one in common. At most kMostSharedPairs are counted, and
/// where corners crowd the search ends after some 300 products of corners for each corner: walls and slopes take 30.
SharedArea shared_area(const std::vector<Loops>& bodies, double least);

}  // namespace keyblock
