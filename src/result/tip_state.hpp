// What pulls at a crack tip at the end of a step, and where the tip goes on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/point.hpp"

namespace keyblock {

struct TipState {
  int crack = 0;        ///< its number, from 0: those of the case file in their order, then joints that end inside
  bool at_end = false;  ///< the tip is the last point of the crack, else the first
  Point at;             ///< undeformed
  double length = 0;    ///< of the crack, all of its pieces
  double mode_1 = 0;    ///< K_I, F/L^1.5
  double mode_2 = 0;
  double energy_release = 0;  ///< J, F/L
  double equivalent = 0;      ///< K_eq of the criterion of growth, F/L^1.5
  double kink = 0;            ///< rad, from straight ahead to the left: where it goes on
  double toughness = 0;       ///< K_Ic; 0: the rock has none
  bool has_room = true;       ///< false: no domain about the tip is free of other lines, and the factors are none
  bool goes_on = false;

  bool operator==(const TipState&) const = default;
};

}  // namespace keyblock
