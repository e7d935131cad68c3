// Finds bodies that overlap.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/common_area.hpp"

namespace keyblock {

inline constexpr int kMostSharedPairs = 1000;  ///< limit of the count

struct SharedArea {
  int first = 0;  ///< the first pair by their numbers
  int second = 0;
  double share = 0;         ///< common area of that pair over the area of the smaller body
  int pairs = 0;            ///< number of pairs; 0 without overlap, as all other members
  bool is_complete = true;  ///< false: corners crowd, and not every pair was tested
};

/// Returns pairs of bodies that share more than `least` of the smaller one. At most kMostSharedPairs are counted. If
/// corners crowd, the search ends after some 300 products of corners per corner; walls and slopes need 30.
SharedArea shared_area(const std::vector<Loops>& bodies, double least);

}  // namespace keyblock
