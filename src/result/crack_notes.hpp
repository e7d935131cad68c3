// Records the worst values of crack growth, by which crack paths and starting loads are judged.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/point.hpp"

namespace keyblock {

/// Worst values over all steps so far; `step` 0: none occurred.
struct CrackNotes {
  struct AtTip {
    int step = 0;
    int crack = 0;         ///< its number, from 0
    Point at;              ///< undeformed
    double increment = 0;  ///< length of the last piece
    double ratio = 0;
  };
  AtTip bent;         ///< greatest |K_II/K_I| behind a static increment; `ratio` is K_II/K_I
  AtTip overlapping;  ///< a tip that propagated with overlapping faces: `ratio` is the least K_I/|K|

  struct Start {
    int step = 0;  ///< of the first
    int count = 0;
    Point at;
    double side = 0;      ///< of the mesh there
    double length = 0;    ///< of the rock, L = (K_Ic/f_t)²/π
    double strength = 0;  ///< required strength, force / length²
    double of_rock = 0;   ///< f_t, in shear c
  };
  Start coarse_start;  ///< a crack that started where the mesh is coarser than L/2
};

}  // namespace keyblock
