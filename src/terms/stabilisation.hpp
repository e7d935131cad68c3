// The two constants that make cut elements and held boundaries harmless, for each kind of cover functions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/cover_basis.hpp"

namespace keyblock {

struct Stabilisation {
  double ghost = 0;    ///< γ of the ghost penalty
  double nitsche = 0;  ///< c in c (degree)² M / h
};

/// Too little makes the matrix indefinite, more costs accuracy: 5 to 20 % of the error for c 50 instead of 20. What
/// binds is a corner held on both sides and cut small along one or both: with these constants none of 240 such meshes
/// (cuts from 0.5 to 1e-8 of a side) and none of 100 turned at random was indefinite; with (0.15, 50), (0.05, 40) and
/// (0.07, 50) for constant, linear and quadratic functions 108 of the 240 were.
constexpr Stabilisation stabilisation(CoverFunctions functions) {
  switch (functions) {
    case CoverFunctions::constant:
      return {0.2, 50};
    case CoverFunctions::derived:
      return {0.05, 20};
    case CoverFunctions::linear:
      return {0.07, 50};
    case CoverFunctions::quadratic:
      return {0.1, 50};
  }
  return {};
}

/// c of the springs along held edges of rock that may yield (held_edges): over the stiffness of the elements.
inline constexpr double kHeldSprings = 1e4;

}  // namespace keyblock
