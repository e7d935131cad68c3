// Where a crack starts in intact rock: strength and toughness in one length.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fracture/tip_integrals.hpp"

namespace keyblock {

/// A crack about to start: its middle, its direction (of length 1, normal to the greatest principal stress), and how
/// near it is.
struct CrackStart {
  Point at;
  Point along;
  double half_length = 0;
  double stress = 0;       ///< greatest principal stress averaged over the disc, force / length²
  double strength = 0;     ///< that it has to reach
  bool is_coarse = false;  ///< the mesh is coarser than half the length of the rock: strength is lowered, energy right

  double nearness() const { return stress / strength; }
};

/// The one that starts first, and those within one per cent of it that lie apart from it; none where no rock has a
/// toughness with a tensile strength, or nothing is pulled. The greatest principal stress is averaged, with the weight
/// (1 - r²/R²)², over a disc of R = L = (K_Ic/f_t)²/π about the middle of each element, through rock that hangs
/// together; a crack of half-length L under f_t has K = K_Ic (theory of critical distances, Taylor 2007; finite
/// fracture mechanics, Leguillon 2002). Where the element's side h is above L/2: R = 2h and the strength K_Ic/√(2 π
/// h) (crack band, Bažant & Oh 1983). Within 2 R of a tip that tip goes on instead.
std::vector<CrackStart> crack_starts(const CoverSolution& solution);

}  // namespace keyblock
