// Draws random numbers, points and polygons. They may be anything that readers take, sensible or not.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "problem/drawing.hpp"
#include "tests/validate/dice.hpp"

namespace keyblock::support::drawn {

/// All orders of magnitude that readers take, both signs, and now and then 0 or a whole number.
inline double any_real(Dice& dice) {
  if (dice.happens(0.1)) return 0;
  const double size = dice.happens(0.2) ? dice.below(1000) + 1 : dice.magnitude_between(1e-50, 1e50);
  return dice.happens(0.5) ? size : 0.0 - size;
}

inline double positive_real(Dice& dice) {
  return dice.magnitude_between(1e-50, 1e50);
}

inline double coordinate(Dice& dice) {
  return dice.happens(0.5) ? dice.below(20) - 10 : dice.between(-1e4, 1e4);
}

inline Point any_point(Dice& dice) {
  const double x = coordinate(dice);
  return {x, coordinate(dice)};
}

inline Segment any_segment(Dice& dice) {
  const Point start = any_point(dice);
  return {start, dice.happens(0.1) ? start : any_point(dice)};
}

template <typename Draw>
auto some(Dice& dice, int most, Draw draw) {
  std::vector<decltype(draw(dice))> items;
  for (int left = dice.below(most + 1); left > 0; --left) items.push_back(draw(dice));
  return items;
}

inline MarkedPoint mark(Dice& dice) {
  return {any_point(dice), {}};
}

/// A polygon of 3 to 9 corners about a place of its own, counter-clockwise.
inline std::vector<Point> polygon(Dice& dice) {
  const Point centre = any_point(dice);
  const int corners = 3 + dice.below(7);
  std::vector<Point> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * (i + dice.between(0, 0.9)) / corners;
    points.push_back(centre + dice.between(0.5, 2) * Point{std::cos(angle), std::sin(angle)});
  }
  return points;
}

}  // namespace keyblock::support::drawn
