// Generates joint sets from statistics: traces of given dip, spacing, length and gap, with random scatter.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "geometry/point.hpp"
#include "problem/joints/random_value.hpp"

namespace keyblock {

/// Joint set: parallel rows, on each row traces and gaps of rock between them.
struct JointSet {
  double dip_deg = 0;                        ///< from the x axis, counter-clockwise
  double dip_scatter = 0;                    ///< standard deviation of the dip over a quarter turn; normal law
  RandomLength spacing;                      ///< between rows, across them
  std::optional<RandomLength> trace_length;  ///< empty: traces have no ends
  RandomLength gap;                          ///< between traces of a row (the bridge)
  int joint_material = 0;                    ///< index from 0
  std::uint64_t seed = 0;
  std::uint64_t stream = 0;  ///< sets with one seed differ in this, so that a further set does not change the others
  Place place;
};

/// Limit on traces; no run could cut more.
inline constexpr std::size_t kMostTraces = 1000000;

/// Returns the traces of a set around `centre`. They are drawn over a circle of twice the radius `reach`, so that
/// rotated traces also enter from outside. Rows and traces begin at random before the circle. Throws InputError for
/// more than kMostTraces.
std::vector<Segment> traces(const JointSet& set, Point centre, double reach);

}  // namespace keyblock
