// Defines the constants that stabilise cut elements and fixed boundaries, for each kind of cover functions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/cover_basis.hpp"

namespace keyblock {

struct Stabilisation {
  double ghost = 0;    ///< γ of the ghost penalty
  double nitsche = 0;  ///< c in c (degree)² M / h
};

/// Returns the constants for a kind of functions. Lower values make the matrix indefinite, higher ones cost accuracy: c
/// 50 instead of 20 adds 5 to 20 % to the error.
///
/// The worst case is a corner fixed on both sides and cut small along one or both. With these constants none of 240
/// such meshes (cuts from 0.5 to 1e-8 of a side) and of 100 rotated at random was indefinite. With (0.15, 50), (0.05,
/// 40) and (0.07, 50) for constant, linear and quadratic functions 108 of the 240 were.
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

/// c of the springs along fixed edges of elastoplastic rock (held_edges), relative to the stiffness of the elements.
inline constexpr double kHeldSprings = 1e4;

}  // namespace keyblock
