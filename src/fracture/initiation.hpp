// Finds where a crack starts in intact rock, from strength and toughness combined in one length.
// Theory: docs/theory/10-fracture.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fracture/tip_integrals.hpp"

namespace keyblock {

/// Crack about to start: its middle, its direction (of length 1), and how near it is to starting.
struct CrackStart {
  Point at;
  Point along = {};
  double half_length = 0;
  double stress = 0;  ///< mean over the disc, force / length²: the greatest principal stress, normal to the crack; in
                      ///< shear, the shear stress along it minus friction
  double strength = 0;          ///< stress at which it starts
  double toughness = 0;         ///< K_Ic of the rock, in shear K_IIc, F/L^1.5
  bool is_shear = false;        ///< its faces stay closed and rub
  double side = 0;              ///< of the mesh there
  double length_of_rock = 0;    ///< L
  double strength_of_rock = 0;  ///< f_t, in shear c

  double nearness() const { return stress / strength; }
  /// Returns true if the mesh is coarser than half the length of the rock.
  bool is_coarse() const { return side > length_of_rock / 2; }
};

/// Returns the crack that starts first, and those within one per cent of it that lie apart from it. Returns none if no
/// rock has a toughness with a tensile strength or cohesion, or if no rock is loaded that way.
///
/// The greatest principal stress is averaged, with the weight (1 - r²/R²)², over a disc of R = L = (K_Ic/f_t)²/π around
/// the middle of each element, through connected rock. A crack of half-length L under f_t has K = K_Ic (theory of
/// critical distances, Taylor 2007; finite fracture mechanics, Leguillon 2002).
///
/// If the element's side h is above L/2, the mesh does not resolve that average, and it is extrapolated. Stress that
/// the mesh resolves varies little over an element: R = max(L, h/2), and the strength is f_t. If a corner that opens
/// into the rock lies within h (`rock_corners`), stress grows towards it as r^-α, and so does its average. Then R = 2h,
/// and the strength is f_t (L/2h)^α, which is K_Ic/√(2πh) at a notch as sharp as a crack (crack band, Bažant & Oh 1983;
/// notches, Seweryn 1994). The crack that starts has the half-length 2h.
///
/// If rock has a cohesion, closed cracks start in shear by the same rule, with K_IIc, L = (K_IIc/c)²/π and c for the
/// strength. They start along the plane on which |τ| + σ tan φ is greatest, at 45° - φ/2 to the greatest compression
/// (Coulomb 1773). As the crack slides, its drop of stress is c if it rubs as the rock did. Of the two such planes the
/// one with the greater value at its ends, L away, is chosen. Within two half-lengths of a tip that tip propagates
/// instead.
std::vector<CrackStart> crack_starts(const CoverSolution& solution);

}  // namespace keyblock
