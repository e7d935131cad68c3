// Draws lines for large checks: random lines, two joint sets, and lines between points of a lattice.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>

#include "problem/drawing.hpp"
#include "tests/validate/dice.hpp"

namespace keyblock {

inline void add_line(Drawing& drawing, Point start, Point end) {
  if (start == end) return;
  drawing.joints.push_back({{start, end}, 0, {"random", static_cast<int>(drawing.joints.size()) + 1, 0}});
}

/// Draws lines of the given length in all directions over the unit square.
inline Drawing random_lines(int count, double length, std::uint64_t seed) {
  Dice dice(seed);
  Drawing drawing;
  while (static_cast<int>(drawing.joints.size()) < count) {
    const Point at{dice.between(0, 1), dice.between(0, 1)};
    const double angle = dice.between(0, 2 * std::acos(-1.0));
    add_line(drawing, at, at + length * Point{std::cos(angle), std::sin(angle)});
  }
  return drawing;
}

/// Draws two sets of joints, at 20 and 105 degrees with a scatter of 3, over the unit square.
inline Drawing two_joint_sets(int count, double length, std::uint64_t seed) {
  Dice dice(seed);
  Drawing drawing;
  const double degree = std::acos(-1.0) / 180;
  for (int i = 0; i < count; ++i) {
    const Point at{dice.between(0, 1), dice.between(0, 1)};
    const double angle = degree * ((i % 2 == 0 ? 20 : 105) + dice.between(-3, 3));
    add_line(drawing, at, at + length * Point{std::cos(angle), std::sin(angle)});
  }
  return drawing;
}

/// Draws lines between near points of a lattice: coinciding ends, many lines through one point, overlaps and
/// repetitions.
inline Drawing lattice_lines(int count, int size, int reach, std::uint64_t seed) {
  Dice dice(seed);
  Drawing drawing;
  while (static_cast<int>(drawing.joints.size()) < count) {
    const Point at{static_cast<double>(dice.below(size)), static_cast<double>(dice.below(size))};
    const Point step{static_cast<double>(dice.below(2 * reach + 1) - reach),
                     static_cast<double>(dice.below(2 * reach + 1) - reach)};
    add_line(drawing, at, at + step);
  }
  return drawing;
}

}  // namespace keyblock
